"""The shipped circuits, read once for all tests."""

from functools import cache
from pathlib import Path

from f1tenth_judge.places.centreline import centreline
from f1tenth_judge.places.circuit_file import load_circuit
from f1tenth_judge.places.lap import Lap
from shapely.geometry import Point, Polygon
from shapely.ops import unary_union

import f1tenth_sim2d

PACKAGE = Path(__file__).parent.parent
NAMES = sorted(path.stem for path in (PACKAGE / "circuits").glob("*.yaml"))
LIDAR_HEIGHT = 0.16


def circuit(name):
    return load_circuit(PACKAGE / "circuits" / f"{name}.yaml")


@cache
def lap(name):
    return Lap(centreline(circuit(name)))


@cache
def world(name):
    return f1tenth_sim2d.load_world(str(PACKAGE / "worlds" / f"{name}.world"), [])


@cache
def solid(name, height=LIDAR_HEIGHT):
    """Everything solid and static at a height, as one shape."""
    outlines, circles = world(name).section(height)
    return unary_union([Polygon(o) for o in outlines] + [Point(x, y).buffer(r, 32) for x, y, r in circles])


def goals(name):
    """The (x, y, yaw) of a goals file."""
    lines = (PACKAGE / "goals" / f"{name}.txt").read_text().splitlines()
    assert lines[0] == "frame_id: map"
    return [tuple(map(float, line.split())) for line in lines[1:] if not line.startswith("#")]
