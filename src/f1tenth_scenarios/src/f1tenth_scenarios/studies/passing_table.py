"""Laps past a slower car on each circuit, as a table: the command `passing_laps`."""

import argparse
import math
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Optional

from f1tenth_scenarios import places
from f1tenth_scenarios.studies.passing_run import CLEARLY_SLOWER, Run, drive
from f1tenth_scenarios.studies.race_pace.cli import add_circuits, guarded, write_table

# Exit codes, besides that of bad input.
GOOD, NOT_GOOD = 0, 1

_SPEEDS = (0.6, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0)  # m/s
_FASTEST = 20.0  # m/s, what a scenario allows

_HEAD = """# Passing a slower car

Laps at race pace on a road on which another car keeps to the middle at a speed of its own and takes no
notice, made by

    rosrun f1tenth_scenarios passing_laps --table docs/passing.md

The planner has perfect odometry, and from its lidar alone where the other is and how fast. The other stands
2.5 m before it at the start; whoever is fast meets it again in each lap.

Wanted: no contact, and a car of up to {slower:g} m/s is passed.

| circuit | other (m/s) | laps | slowest lap (s) | passed (times) | least clearance (m) | contacts |
| --- | --- | --- | --- | --- | --- | --- |
"""


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run `passing_laps`; returns the exit code: 1 when a run was not good enough."""
    parser = argparse.ArgumentParser(prog="passing_laps", description="Drives laps past a slower car.")
    add_circuits(parser, "circuit")
    parser.add_argument("--laps", type=_count, default=3, metavar="N", help="of each run (%(default)s)")
    parser.add_argument(
        "--speeds",
        type=_speeds,
        default=_SPEEDS,
        metavar="A,B,C",
        help=f"of the other car, m/s (default: {','.join(f'{each:g}' for each in _SPEEDS)})",
    )
    parser.add_argument("--table", type=Path, metavar="FILE", help="write the table there, too")
    parser.add_argument("--results", type=Path, metavar="FOLDER", help="default: results/passing")
    return guarded(parser.prog, _drive, parser.parse_args(arguments))


def _count(text: str) -> int:
    number = int(text) if text.isdecimal() else 0
    if number < 1:
        raise argparse.ArgumentTypeError(f"found '{text}', must be a whole number, at least 1")
    return number


def _speeds(text: str) -> list[float]:
    try:
        speeds = [float(each) for each in text.split(",")]
    except ValueError:
        speeds = []
    if not speeds or not all(0.0 < each <= _FASTEST for each in speeds):
        raise argparse.ArgumentTypeError(
            f"found '{text}', must be speeds above 0 and at most {_FASTEST:g} m/s, as in 0.6,1.5"
        )
    return speeds


def _drive(options) -> int:
    folder = (options.results or places.results_folder("passing")).resolve()
    runs = {
        circuit: [drive(circuit, speed, options.laps, folder) for speed in options.speeds]
        for circuit in options.names
    }
    table = make_table(runs)
    print(table)
    if options.table:
        write_table(options.table, table)
    problems = [
        f"{circuit}, {each.speed:g} m/s: {each.problem()}"
        for circuit in runs
        for each in runs[circuit]
        if each.problem()
    ]
    for text in problems:
        print(f"passing_laps: {text}", file=sys.stderr)
    return NOT_GOOD if problems else GOOD


def make_table(runs: dict[str, Sequence[Run]]) -> str:
    """The whole document, in Markdown."""
    rows = [_row(circuit, each) for circuit, of_circuit in runs.items() for each in of_circuit]
    return _HEAD.format(slower=CLEARLY_SLOWER) + "".join(rows)


def _row(circuit: str, run: Run) -> str:
    cells = (
        circuit,
        f"{run.speed:g}",
        str(len(run.lap_times)),
        f"{max(run.lap_times, default=math.inf):.3f}",
        str(run.passes),
        f"{run.clearance:.3f}",
        str(run.contacts),
    )
    return f"| {' | '.join(cells)} |\n"
