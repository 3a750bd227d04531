"""Environments to learn driving in: Gymnasium's API, single and vectorized, and PettingZoo's."""

ENVIRONMENT = "F1Tenth-v0"
"""Id of the environment among Gymnasium's."""


def register():
    """Make the environment known to Gymnasium; a second time does no harm."""
    import gymnasium

    if ENVIRONMENT not in gymnasium.registry:
        gymnasium.register(
            ENVIRONMENT,
            entry_point="f1tenth_sim2d.environments.single:F1TenthEnv",
            vector_entry_point="f1tenth_sim2d.environments.vector:F1TenthVectorEnv",
        )


def parallel_env(**settings):
    """Return a PettingZoo environment of several cars on one road; see ParallelEnv for the settings."""
    from f1tenth_sim2d.environments.parallel import F1TenthParallelEnv

    return F1TenthParallelEnv(**settings)
