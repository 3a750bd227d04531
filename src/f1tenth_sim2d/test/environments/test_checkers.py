"""The checkers of Gymnasium and PettingZoo have nothing to say."""

import warnings

import gymnasium
import pytest
from f1tenth_sim2d.environments import ENVIRONMENT
from gymnasium.utils.env_checker import check_env

from f1tenth_sim2d import parallel_env

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # of PettingZoo about itself
    from pettingzoo.test import parallel_api_test, parallel_seed_test

ALL_PARTS = ("scan", "pose", "velocity", "steering", "course", "laps", "contact", "others", "imu")
DRAWN = {"start": "random", "vehicle": {"mu": (0.8, 1.1)}, "lidar_noise": (0.0, 0.02)}


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    "settings",
    [
        {},
        {"cars": 3, "observation": ALL_PARTS, **DRAWN},
        {"flatten": True, "actions": "acceleration"},
    ],
    ids=["default", "three_cars", "flat"],
)
def test_gymnasium_has_no_warning(settings):
    check_env(gymnasium.make(ENVIRONMENT, place="circuit1", beams=20, **settings).unwrapped)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("settings", [{}, {"flatten": True, **DRAWN}], ids=["default", "flat"])
def test_stable_baselines3_has_no_warning(settings):
    checker = pytest.importorskip("stable_baselines3.common.env_checker", reason="no stable-baselines3")
    checker.check_env(gymnasium.make(ENVIRONMENT, place="circuit1", **settings).unwrapped)


@pytest.mark.parametrize("settings", [{}, {"cars": 4, **DRAWN}], ids=["default", "four_cars"])
def test_pettingzoo_passes(settings):
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "options: found")  # one that its test gives
        parallel_api_test(parallel_env(place="circuit1", beams=20, **settings), num_cycles=150)
    parallel_seed_test(lambda: parallel_env(place="circuit1", beams=20, **settings))
