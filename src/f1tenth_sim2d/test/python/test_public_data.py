"""The worlds and models that come with the workspace load as they are meant."""

from pathlib import Path

import pytest

import f1tenth_sim2d

DATA = Path(__file__).parents[4] / "data"
MODELS = sorted(path.name for path in (DATA / "gazebo_models").iterdir())


@pytest.mark.parametrize(("world", "models"), [("cones", 5), ("hall", 12), ("yard", len(MODELS))])
def test_world_loads_without_a_warning(world, models):
    loaded = f1tenth_sim2d.load_world(str(DATA / "worlds" / f"{world}.world"), [str(DATA / "gazebo_models")])
    assert (len(loaded.models), loaded.warnings) == (models, [])


@pytest.mark.parametrize("name", MODELS)
def test_a_lidar_sees_each_model(name, car, tmp_path):
    world = tmp_path / "one.world"
    include = f"<include><uri>model://{name}</uri></include>"
    world.write_text(f"<sdf version='1.6'><world name='w'>{include}</world></sdf>")
    loaded = f1tenth_sim2d.load_world(str(world), [str(DATA / "gazebo_models")])
    assert loaded.warnings == []
    simulation = f1tenth_sim2d.Simulation(loaded)
    simulation.add_car(car, None, -3.0, 0.0, 0.0)
    assert 1.0 < simulation.scan(0, exact=True).min() < 4.0
