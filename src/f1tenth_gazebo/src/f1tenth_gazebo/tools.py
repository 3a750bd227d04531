"""The command lines of make_world, make_goals, make_map and make_centerline."""

import argparse
import functools
import sys
from pathlib import Path

from f1tenth_judge.atomic import write_all
from f1tenth_judge.errors import FileError, MapError
from f1tenth_judge.places.centreline import centreline
from f1tenth_judge.places.centreline_file import centreline_beside, centreline_text, table_text
from f1tenth_judge.places.circuit_file import load_circuit
from f1tenth_judge.places.map_file import load_map, save_map

from f1tenth_gazebo.goals.goals_file import goals_text, lap_goals
from f1tenth_gazebo.maps.road_middle import middle_of_road
from f1tenth_gazebo.maps.world_grid import LIDAR_HEIGHT, world_grid
from f1tenth_gazebo.outputs import named_path
from f1tenth_gazebo.worlds.world_file import world_text

_CIRCUIT = ("circuit", "YAML file of the circuit")


def make_world(arguments=None):
    """Write the world of a circuit and its centreline; return the exit code."""
    what = "Write the Gazebo world of a circuit and its centreline."
    parser = _parser("make_world", what, _CIRCUIT, "NAME.world", "writes it and NAME_centerline.csv")
    options = parser.parse_args(arguments)
    return _run(lambda: _write_world(load_circuit(options.circuit), options.output))


def make_goals(arguments=None):
    """Write the goals for one lap of a circuit; return the exit code."""
    what = "Write the goals for one lap of a circuit."
    parser = _parser("make_goals", what, _CIRCUIT, "FILE", "goals file to write")
    options = parser.parse_args(arguments)
    return _run(
        lambda: write_all({options.output: circuit_goals_text(load_circuit(options.circuit)).encode()})
    )


def make_map(arguments=None):
    """Write the map of a world; return the exit code."""
    what = "Write the map of a world as map_saver does."
    parser = _parser("make_map", what, ("world", "world file"), "NAME", "writes NAME.pgm and NAME.yaml")
    parser.add_argument(
        "--height", type=float, default=LIDAR_HEIGHT, help="of the section, m (default %(default)s)"
    )
    parser.add_argument(
        "--extent",
        type=float,
        nargs=4,
        metavar=("XMIN", "YMIN", "XMAX", "YMAX"),
        help="of an open world: what to map, m (default: what walls enclose around the origin)",
    )
    options = parser.parse_args(arguments)
    grid = functools.partial(world_grid, options.world, options.height, options.extent)
    return _run(lambda: save_map(grid(), options.output))


def make_centerline(arguments=None):
    """Write the middle of the road that a map shows; return the exit code."""
    what = "Write the middle of the closed road that a map shows, and how wide it is."
    source, default = ("map", "YAML file of the map"), "default: NAME_centerline.csv beside the map"
    parser = _parser("make_centerline", what, source, "FILE", default, required=False)
    parser.add_argument(
        "--start",
        type=float,
        nargs=3,
        default=(0.0, 0.0, 0.0),
        metavar=("X", "Y", "YAW"),
        help="where it begins and which way it goes in the map frame, m and rad (default: 0 0 0)",
    )
    options = parser.parse_args(arguments)
    return _run(lambda: _write_middle(Path(options.map), options.start, options.output))


def _parser(name, what, source, output, output_help, required=True):
    """The parser of a command that makes files from one; `source`: what that is called, and what it is."""
    parser = argparse.ArgumentParser(prog=name, description=what)
    parser.add_argument(source[0], help=source[1])
    parser.add_argument(
        "-o", dest="output", type=named_path, required=required, metavar=output, help=output_help
    )
    return parser


def circuit_goals_text(circuit):
    """The goals file of a circuit."""
    return goals_text(lap_goals(centreline(circuit)), circuit.name)


def _write_world(circuit, path):
    world, line = world_text(circuit), centreline_text(circuit)
    write_all({path: world.encode(), path.with_name(f"{path.stem}_centerline.csv"): line.encode()})


def _write_middle(path, start, output):
    grid = load_map(path, may_be_turned=True)
    try:
        rows = middle_of_road(grid, start)
    except MapError as error:
        raise MapError(f"{path}: {error}") from error
    write_all({output or centreline_beside(path): table_text(rows).encode()})


def _run(action):
    try:
        action()
    except FileError as error:
        print(error, file=sys.stderr)
        return 1
    except OSError as error:
        print(f"{error.filename}: cannot be written: {error.strerror}", file=sys.stderr)
        return 1
    return 0
