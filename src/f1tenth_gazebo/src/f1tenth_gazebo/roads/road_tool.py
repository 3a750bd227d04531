"""The command line of make_road."""

import argparse
import dataclasses
import sys

from f1tenth_gazebo.outputs import named_path
from f1tenth_gazebo.roads.road import make_road
from f1tenth_gazebo.roads.road_files import write_road
from f1tenth_gazebo.roads.road_options import RoadError, RoadOptions


def main(arguments=None):
    """Write a random road; return the exit code: 1 if there is no such road, 2 for bad input."""
    options = vars(_parser().parse_args(arguments))
    seed, stem = options.pop("seed"), options.pop("output")
    stem = stem or f"road_{seed}"
    try:
        given = {name: value for name, value in options.items() if value is not None}
        road = make_road(seed, **given)
        paths = write_road(road, stem)
    except RoadError as error:
        print(f"make_road: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"make_road: {error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    made = road.options
    print(
        f"{road.line.length:.1f} m long, {road.least_width():.2f} m wide at least, least radius "
        f"{road.least_radius():.2f} m, longest straight {made.straight:.1f} m, hairpins {made.hairpins}, "
        f"chicanes {made.chicanes}, gaps {made.gaps}, islands {made.islands}: {', '.join(map(str, paths))}"
    )
    return 0


def _parser():
    parser = argparse.ArgumentParser(
        prog="make_road",
        description="Write a random closed road that can be driven: map, centreline and world. The seed "
        "draws what is not given.",
    )
    parser.add_argument("--seed", type=int, required=True, help="0 or above; the same one, the same road")
    for option in dataclasses.fields(RoadOptions):
        low, high = option.metadata["limits"]
        kind = _width if option.name == "width" else type(low)
        parser.add_argument(
            f"--{option.name}", type=kind, help=f"{option.metadata['help']} ({low:g} to {high:g})"
        )
    parser.add_argument(
        "-o",
        dest="output",
        type=named_path,
        metavar="NAME",
        help="writes NAME.pgm, NAME.yaml, NAME_centerline.csv, NAME.world; default: road_SEED",
    )
    return parser


def _width(text):
    try:
        least, greatest = map(float, text.split(":") if ":" in text else (text, text))
    except ValueError:
        raise argparse.ArgumentTypeError(f"found {text!r}, allowed: M or LOW:HIGH") from None
    return least, greatest
