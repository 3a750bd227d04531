"""The map of a world."""

from f1tenth_judge.errors import CircuitError

import f1tenth_sim2d
from f1tenth_gazebo.maps.occupancy import occupancy_grid, open_grid

LIDAR_HEIGHT = 0.16
"""Of the car's scan plane above the ground, m."""


def world_grid(world, height=LIDAR_HEIGHT, extent=None):
    """Occupancy grid of what stands still in a world, at a height (m).

    Args:
        world: its file.
        height: m.
        extent: of an open world, see open_grid.

    Raises:
        CircuitError: if the world cannot be read, or is not closed around the origin and no extent is given.
    """
    try:
        outlines, circles = f1tenth_sim2d.load_world(str(world)).section(height)
        return open_grid(outlines, circles, extent) if extent else occupancy_grid(outlines, circles)
    except f1tenth_sim2d.Error as error:
        raise CircuitError(str(error)) from error
    except CircuitError as error:
        raise CircuitError(f"{world}: {error}") from error
