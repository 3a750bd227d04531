"""A small world and a small car for the tests of the Python module."""

from pathlib import Path

import pytest

import f1tenth_sim2d

CAR = Path(__file__).parents[1] / "loaders" / "data" / "small_car.urdf"


def model(name, placing, geometry):
    """Return a model of one link with one collision element."""
    collision = f"<collision name='collision'><geometry>{geometry}</geometry></collision>"
    return f"<model name='{name}'>{placing}<link name='link'>{collision}</link></model>"


WALL = model("wall", "<static>true</static><pose>5 0 0.5 0 0 0</pose>", "<box><size>0.2 8 1</size></box>")
POST = model(
    "post",
    "<static>true</static><pose>0 3 0.5 0 0 0</pose>",
    "<cylinder><radius>0.25</radius><length>1</length></cylinder>",
)
CRATE = model("crate", "<pose>0 -3 0.25 0 0 0.5</pose>", "<box><size>0.5 0.5 0.5</size></box>")
WORLD = f"<sdf version='1.6'><world name='room'>{WALL}{POST}{CRATE}</world></sdf>"


@pytest.fixture
def world_file(tmp_path):
    path = tmp_path / "room.world"
    path.write_text(WORLD)
    return str(path)


@pytest.fixture
def world(world_file):
    return f1tenth_sim2d.load_world(world_file)


@pytest.fixture
def car_text():
    return CAR.read_text()


@pytest.fixture
def car(car_text):
    return f1tenth_sim2d.load_car(car_text, "robot1", str(CAR))


@pytest.fixture
def simulation(world, car):
    simulation = f1tenth_sim2d.Simulation(world, seed=7)
    simulation.add_car(car)
    return simulation
