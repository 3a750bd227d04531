"""The command line of check_map."""

import argparse
import math
import sys
from pathlib import Path

from f1tenth_judge.errors import MapError
from f1tenth_judge.places.map_file import load_map

import f1tenth_sim2d
from f1tenth_gazebo.maps.map_alignment import Alignment, aligned
from f1tenth_gazebo.maps.map_check import check_map
from f1tenth_gazebo.maps.world_grid import LIDAR_HEIGHT
from f1tenth_gazebo.worlds.find_world import WorldError, find_world


def main(package_folder, arguments=None):
    """Compare a map with its world; return the exit code: 1 if it fails, 2 for bad input.

    Args:
        package_folder: where worlds/ lies.
        arguments: those of the command line; default: of this process.
    """
    parser = argparse.ArgumentParser(
        prog="check_map", description="Compare a map that a car has made with its world."
    )
    parser.add_argument("map", help="YAML file of the map")
    parser.add_argument("world", metavar="NAME|PATH", help="of the world, as world_file_name of launch files")
    parser.add_argument(
        "--align",
        action="store_true",
        help="lay the map onto the world first, by a turn and a shift: its shape alone is judged",
    )
    options = parser.parse_args(arguments)
    try:
        world = find_world(options.world, Path(package_folder) / "worlds", Path.cwd())
        lies, result = _compared(options.map, world, options.align)
    except (f1tenth_sim2d.Error, MapError, WorldError) as error:
        print(error, file=sys.stderr)
        return 2
    if options.align:
        shift = math.hypot(lies.x, lies.y)
        print(f"laid onto the world by {1000.0 * lies.turn:.2f} mrad and {shift:.3f} m")
    print(
        f"wall cells within {result.near:.2f} m of a true wall: {100.0 * result.cells_near_walls:.1f} %, "
        f"true walls within {result.near:.2f} m of a wall cell: {100.0 * result.walls_near_cells:.1f} %, "
        f"worst cell: {result.worst_cell:.2f} m: {'passed' if result.passed else 'failed, 97 % is the limit'}"
    )
    return 0 if result.passed else 1


def _compared(map_file, world, align):
    """How the map lies in the world, and how far they agree."""
    section = f1tenth_sim2d.load_world(str(world)).section(LIDAR_HEIGHT)
    grid = load_map(Path(map_file))
    try:
        lies = aligned(grid, *section) if align else Alignment()
        return lies, check_map(grid, *lies.section_on_map(*section))
    except MapError as error:
        raise MapError(f"{map_file}, {world}: {error}") from error
