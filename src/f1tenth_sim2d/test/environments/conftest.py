"""What the tests of the environments have in common."""

import os

import gymnasium
import numpy as np
import pytest
from f1tenth_sim2d.environments import ENVIRONMENT, register

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
register()


@pytest.fixture
def make():
    """Make an environment without the wrappers, which would look at actions before it does."""
    made = []

    def make(**settings):
        made.append(gymnasium.make(ENVIRONMENT, **{"place": "circuit1", **settings}).unwrapped)
        return made[-1]

    yield make
    for environment in made:
        environment.close()


def straight_on(speed_share=-0.4):
    """An action that does not steer: -0.4 is 2.5 m/s."""
    return np.array([0.0, speed_share], dtype=np.float32)
