"""In place of gym for programs written for f1tenth_gym: `import f1tenth_sim2d.f110_gym as gym`."""

from f1tenth_sim2d import f1tenth_gym
from f1tenth_sim2d.f110_env import F110Env, Integrator

__all__ = ["F110Env", "Integrator", "make"]
_IDS = ("f110_gym:f110-v0", "f110-v0")


def make(environment="f110_gym:f110-v0", **settings):
    """Return an F110Env, in place of gym.make; that of version 1.0 for its id, or with a `config`.

    Raises:
        ValueError: as F110Env, and for another environment.
    """
    if environment not in (*_IDS, *f1tenth_gym.IDS):
        allowed = ", ".join((*_IDS, *f1tenth_gym.IDS))
        raise ValueError(f"environment: found {environment!r}, allowed are {allowed}")
    if environment in f1tenth_gym.IDS or "config" in settings:
        return f1tenth_gym.F110Env(**{"config": {}, **settings})
    return F110Env(**settings)
