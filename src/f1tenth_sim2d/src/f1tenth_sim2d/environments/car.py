"""The workspace's car with a lidar to choose."""

import functools
from dataclasses import dataclass
from xml.etree import ElementTree

import f1tenth_sim2d
from f1tenth_sim2d.environments.data import data_path
from f1tenth_sim2d.environments.xacro_file import expanded


@dataclass(frozen=True)
class Lidar:
    """A planar lidar that faces ahead and sees equally far to both sides."""

    beams: int
    field_of_view: float  # rad
    range_max: float  # m


def load_cars(names, lidar):
    """Return descriptions of cars of these names."""
    text = with_lidar(_description(), lidar)
    return [f1tenth_sim2d.load_car(text, name, "f1tenth.urdf.xacro") for name in names]


def numbered(count):
    """Names of cars as the simulator's launch files have them: robot1, robot2, …."""
    return [f"robot{i + 1}" for i in range(count)]


def numbered_agents(count):
    """Names of cars as PettingZoo has them: car_0, car_1, …."""
    return [f"car_{i}" for i in range(count)]


def with_lidar(text, lidar):
    """Return a robot description with its lidars replaced."""
    robot = ElementTree.fromstring(text)
    values = {
        "samples": lidar.beams,
        "min_angle": -lidar.field_of_view / 2,
        "max_angle": lidar.field_of_view / 2,
        "max": lidar.range_max,
    }
    for ray in robot.iter("ray"):
        for tag, value in values.items():
            for element in ray.iter(tag):
                element.text = repr(value)
    return ElementTree.tostring(robot, "unicode")


@functools.lru_cache(maxsize=1)
def _description():
    return expanded(data_path("f1tenth_description/urdf/f1tenth.urdf.xacro"))
