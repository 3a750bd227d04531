"""Where a car starts in a world, and where its road leads from there."""

import math

import numpy as np

from f1tenth_gazebo.circuits.centreline import centreline
from f1tenth_gazebo.circuits.centreline_file import centreline_beside
from f1tenth_gazebo.circuits.circuit import Pose
from f1tenth_gazebo.circuits.circuit_file import load_circuit
from f1tenth_gazebo.circuits.lap import Lap

_SPACING = 3.0  # m, between the places at which the direction is shown


def road_ahead(world, circuits_folder):
    """Poses along the road in driving order; the first is the start. Only a start where no road is known.

    Args:
        world: path of a .world file or of the .yaml file of a map
        circuits_folder: where circuits are described

    Raises:
        OSError, ValueError: the centreline beside a map cannot be read.
        FileError: the description of a circuit is wrong.
    """
    table = centreline_beside(world)
    if table.is_file():
        return _along_points(np.loadtxt(table, delimiter=",", comments="#", ndmin=2)[:, :2])
    circuit = circuits_folder / f"{world.stem}.yaml"
    # A world of somebody else's may have the name of a circuit.
    if circuit.is_file() and circuits_folder.parent == world.parent.parent:
        lap = Lap(centreline(load_circuit(circuit)))
        return [lap.pose(place) for place in np.arange(0.0, lap.length, _SPACING)]
    return [Pose(0.0, 0.0, 0.0)]


def _along_points(points):
    closed = np.vstack([points, points[:1]])
    steps = np.diff(closed, axis=0)
    at = np.concatenate([[0.0], np.cumsum(np.hypot(*steps.T))])
    chosen = [int(np.searchsorted(at, place)) for place in np.arange(0.0, at[-1], _SPACING)]
    return [
        Pose(float(points[i][0]), float(points[i][1]), math.atan2(steps[i][1], steps[i][0]))
        for i in chosen
        if i < len(points)
    ]
