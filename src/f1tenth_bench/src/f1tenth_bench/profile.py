"""What a step of an environment is made of: instructions by part, counted by callgrind.

python3 -m f1tenth_bench.profile [--place PLACE] [--beams N ...] [--cars N ...] [--range M]
"""

import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import gymnasium
import numpy as np
from f1tenth_sim2d.environments import ENVIRONMENT, register

from f1tenth_bench.places import data_file

ENVIRONMENTS, STEPS = 4, 60
PARTS = {
    "whole step": r"f1tenth_sim2d::Environments::step\(",
    "physics": r"f1tenth_sim2d::Simulation::step\(",
    "- dynamics": r"f1tenth_sim2d::Car::predict\(",
    "- clearance": r"f1tenth_sim2d::clearance\(",
    "- Box2D": r"b2World::Step\(",
    "- state, odometry": r"f1tenth_sim2d::Car::commit\(",
    "course": r"f1tenth_sim2d::Course::locate\(",
    "scan": r"f1tenth_sim2d::Simulation::scan\(",
    "- walls": r"f1tenth_sim2d::LidarScene::draw\(",
    "- noise": r"f1tenth_sim2d::gaussians\(",
}
"""Names of functions, each with all that it calls."""


def drive(place, beams, cars, range_max):
    """Drive along the road at 4 m/s."""
    register()
    settings = {"period": 0.01, "beams": beams, "range_max": range_max, "field_of_view": 4.7, "cars": cars}
    environments = gymnasium.make_vec(
        ENVIRONMENT,
        ENVIRONMENTS,
        "vector_entry_point",
        threads=1,
        place=place,
        start="random",
        normalized=False,
        contact_ends=False,
        **settings,
    )
    _, info = environments.reset(seed=1)
    for _ in range(STEPS):
        steering = np.clip(-0.8 * info["course_offset"] - 1.2 * info["course_heading"], -0.4, 0.4)
        actions = np.stack([steering, np.full_like(steering, 4.0)], axis=-1)
        *_, info = environments.step(actions.reshape(environments.action_space.shape))


def counted(place, *work):
    """Thousands of instructions of a step of one environment, by part."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "callgrind"
        valgrind = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={output}"]
        valgrind += ["--toggle-collect=f1tenth_sim2d::Environments::step*"]
        driver = [sys.executable, "-m", "f1tenth_bench.profile", "--drive", str(place), *map(str, work)]
        subprocess.run(valgrind + driver, check=True, stderr=subprocess.DEVNULL)
        annotate = ["callgrind_annotate", "--inclusive=yes", "--threshold=100", "--auto=no", str(output)]
        lines = subprocess.run(annotate, check=True, capture_output=True, text=True).stdout.splitlines()
    return {part: _most(lines, name) / ENVIRONMENTS / STEPS / 1e3 for part, name in PARTS.items()}


def _most(lines, name):
    """Of the lines of a function, that of all its clones and inlined parts together."""
    found = [line.split("(")[0] for line in lines if re.search(name, line)]
    return max((int(number.replace(",", "")) for number in found), default=0)


def main():
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--place", default=None, help="default: Spielberg")
    parser.add_argument("--beams", type=int, nargs="+", default=[64, 108, 1080])
    parser.add_argument("--cars", type=int, nargs="+", default=[1, 2, 8])
    parser.add_argument("--range", type=float, default=30.0, help="of the lidar, m")
    parser.add_argument("--drive", nargs=4, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.drive:
        place, beams, cars, range_max = arguments.drive
        drive(place, int(beams), int(cars), float(range_max))
        return
    place = arguments.place or data_file("tracks/Spielberg/Spielberg_map.yaml")
    print("| beams, cars | " + " | ".join(PARTS) + " |\n" + "| --- " * (len(PARTS) + 1) + "|")
    for beams in arguments.beams:
        for cars in arguments.cars:
            numbers = counted(place, beams, cars, arguments.range).values()
            cells = [f"{beams}, {cars}", *(f"{number:.1f}" for number in numbers)]
            print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
