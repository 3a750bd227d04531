"""Environments to learn driving in: Gymnasium's API, single and vectorized, and PettingZoo's."""

import importlib.util

ENVIRONMENT = "F1Tenth-v0"
"""Id of the environment among Gymnasium's."""


def register():
    """Make the environment known to Gymnasium; a second time does no harm."""
    _require("gymnasium")
    import gymnasium

    if ENVIRONMENT not in gymnasium.registry:
        gymnasium.register(
            ENVIRONMENT,
            entry_point="f1tenth_sim2d.environments.single:F1TenthEnv",
            vector_entry_point="f1tenth_sim2d.environments.vector:F1TenthVectorEnv",
        )


def parallel_env(**settings):
    """Return a PettingZoo environment of several cars on one road; see ParallelEnv for the settings."""
    _require("gymnasium")
    _require("pettingzoo")
    from f1tenth_sim2d.environments.parallel import F1TenthParallelEnv

    return F1TenthParallelEnv(**settings)


def _require(module):
    """Say how to get what only learning needs."""
    if importlib.util.find_spec(module) is None:
        remedy = f"`make setup` in the workspace, or pip install {module}"
        raise ModuleNotFoundError(f"environments need {module}, which is missing: {remedy}", name=module)
