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


def load_cars(count, lidar):
    """Return descriptions of cars called robot1, robot2, … as the simulator knows them."""
    text = with_lidar(_description(), lidar)
    return [f1tenth_sim2d.load_car(text, f"robot{i + 1}", "f1tenth.urdf.xacro") for i in range(count)]


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
