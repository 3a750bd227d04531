"""Copies of worlds, simulations and environments."""

import copy
import os
import pickle

import gymnasium
import numpy as np
import pytest
from conftest import straight_on
from f1tenth_sim2d.environments import ENVIRONMENT
from f1tenth_sim2d.environments.car import Lidar, load_cars
from f1tenth_sim2d.environments.place import find_place
from gymnasium.vector import AsyncVectorEnv

import f1tenth_sim2d

SETTINGS = {"place": "circuit1", "start": "random", "beams": 30}


@pytest.fixture
def simulation():
    place = find_place("circuit1")
    made = f1tenth_sim2d.Simulation(place.world, seed=3)
    made.add_car(load_cars(["robot1"], Lidar(30, 4.7, 10.0))[0], None, *place.world.start)
    return made


def driven(simulation, seconds=1.5):
    """Hash and scan after a drive into a wall; the car starts standing."""
    simulation.command(0, 3.0, 0.2)
    simulation.advance_to(simulation.time + seconds)
    return simulation.trajectory_hash(), simulation.scan(0).tobytes(), len(simulation.contacts(0))


def rollout(environment, steps=60):
    rows = []
    for _ in range(steps):
        observation, reward, *ends, info = environment.step(straight_on())
        rows.append((observation["scan"].tobytes(), float(reward), *ends, info["x"].tobytes()))
    return rows


def test_simulation_goes_back_any_number_of_times(simulation):
    driven(simulation, 0.3)
    snapshot = simulation.snapshot()
    first = driven(simulation)
    assert first[2] > 0
    for _ in range(2):
        simulation.restore(snapshot)
        assert simulation.time == pytest.approx(0.3)
        assert driven(simulation) == first


def test_copy_of_a_simulation_goes_on_alone(simulation):
    driven(simulation, 0.3)
    other = copy.deepcopy(simulation)
    assert driven(other) == driven(simulation)
    driven(other)
    assert other.time > simulation.time


def test_world_is_copied_as_itself_and_pickled_as_its_file():
    world = find_place("circuit1").world
    assert copy.deepcopy(world) is world
    assert copy.copy(world) is world
    again = pickle.loads(pickle.dumps(world))
    assert again.file == os.path.abspath(world.file)
    assert [model.name for model in again.models] == [model.name for model in world.models]
    assert pickle.loads(pickle.dumps(f1tenth_sim2d.empty_world())).models == []


def test_copy_of_an_environment_goes_on_alone(make):
    environment = make(**SETTINGS)
    environment.reset(seed=5)
    rollout(environment, 10)
    other = copy.deepcopy(environment)
    assert rollout(other) == rollout(environment)
    first, second = environment.reset()[0]["scan"], other.reset()[0]["scan"]
    assert np.array_equal(first, second)


def test_copy_of_many_environments_goes_on_alone():
    environments = gymnasium.make_vec(ENVIRONMENT, 3, "vector_entry_point", threads=2, **SETTINGS)
    environments.reset(seed=5)
    actions = np.tile(straight_on(), (3, 1))
    environments.step(actions)
    other = copy.deepcopy(environments)
    for _ in range(80):
        ours, theirs = environments.step(actions), other.step(actions)
        assert np.array_equal(ours[0]["scan"], theirs[0]["scan"])
        assert np.array_equal(ours[1], theirs[1])


def test_environment_is_pickled_before_its_first_reset_only(make):
    environment = make(**SETTINGS)
    again = pickle.loads(pickle.dumps(environment))
    environment.reset(seed=2)
    again.reset(seed=2)
    assert rollout(again, 5) == rollout(environment, 5)
    with pytest.raises(TypeError, match="an episode cannot be pickled"):
        pickle.dumps(environment)


def test_recorded_environment_is_not_copied(make, tmp_path):
    environment = make(**SETTINGS, record=tmp_path)
    with pytest.raises(TypeError, match="recorded"):
        copy.deepcopy(environment)


def test_environments_of_other_processes_do_the_same(make):
    environments = AsyncVectorEnv([lambda: gymnasium.make(ENVIRONMENT, **SETTINGS)] * 2)
    try:
        apart, _ = environments.reset(seed=4)
        here = make(**SETTINGS).reset(seed=5)[0]
        assert np.array_equal(apart["scan"][1], here["scan"])
    finally:
        environments.close()
