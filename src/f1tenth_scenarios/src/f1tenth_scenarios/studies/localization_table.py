"""Laps with wheel odometry and amcl on each circuit, as a table: the command `localization_laps`."""

import argparse
import math
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Optional

from f1tenth_scenarios import places
from f1tenth_scenarios.studies.localization_run import GREATEST_ERROR, GREATEST_YAW_ERROR, Run, drive
from f1tenth_scenarios.studies.race_pace.cli import add_circuits, guarded, write_table

# Exit codes, besides that of bad input.
GOOD, NOT_GOOD = 0, 1

_HEAD = """# Localization

Laps with the noisy odometry of the wheels, corrected by amcl on the map (`localization:=amcl`), from the
standing start, made by

    rosrun f1tenth_scenarios localization_laps --table docs/localization.md

The planner drives as in docs/race_pace.md, at race pace, but knows from amcl alone where it is. A car that
corners hard slides, and its wheels do not notice: within 0.1 s they may be wrong by 0.1 m across the way and
by 0.2 rad. Errors are those of `amcl_pose` against the true pose, RMS over a run; of the runs, each with
a seed of its own, the worst counts.

Wanted: every goal passed without contact, at most {error:g} m and {yaw_error:g} degrees.

| circuit | runs | laps each | slowest lap (s) | error (m) | error (deg) | least clearance (m) | contacts |
| --- | --- | --- | --- | --- | --- | --- | --- |
"""


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run `localization_laps`; returns the exit code: 1 when a run was not good enough."""
    parser = argparse.ArgumentParser(
        prog="localization_laps", description="Drives laps with wheel odometry and amcl."
    )
    add_circuits(parser, "circuit")
    parser.add_argument("--laps", type=_count, default=3, metavar="N", help="of each run (%(default)s)")
    parser.add_argument("--runs", type=_count, default=3, metavar="N", help="seeds 1 to N (%(default)s)")
    parser.add_argument("--table", type=Path, metavar="FILE", help="write the table there, too")
    parser.add_argument("--results", type=Path, metavar="FOLDER", help="default: results/localization")
    return guarded(parser.prog, _drive, parser.parse_args(arguments))


def _count(text: str) -> int:
    number = int(text) if text.isdecimal() else 0
    if number < 1:
        raise argparse.ArgumentTypeError(f"found '{text}', must be a whole number, at least 1")
    return number


def _drive(options) -> int:
    folder = (options.results or places.results_folder("localization")).resolve()
    runs = {
        circuit: [drive(circuit, options.laps, seed + 1, folder) for seed in range(options.runs)]
        for circuit in options.names
    }
    table = make_table(runs)
    print(table)
    if options.table:
        write_table(options.table, table)
    problems = [
        f"{circuit}: {each.problem()}" for circuit in runs for each in runs[circuit] if each.problem()
    ]
    for text in problems:
        print(f"localization_laps: {text}", file=sys.stderr)
    return NOT_GOOD if problems else GOOD


def make_table(runs: dict[str, Sequence[Run]]) -> str:
    """The whole document, in Markdown; of each circuit the worst of its runs."""
    head = _HEAD.format(error=GREATEST_ERROR, yaw_error=math.degrees(GREATEST_YAW_ERROR))
    return head + "".join(_row(circuit, each) for circuit, each in runs.items())


def _row(circuit: str, runs: Sequence[Run]) -> str:
    slowest = max((time for each in runs for time in each.lap_times), default=math.inf)
    cells = (
        circuit,
        str(len(runs)),
        str(min(len(each.lap_times) for each in runs)),
        f"{slowest:.3f}",
        f"{max(each.error for each in runs):.3f}",
        f"{math.degrees(max(each.yaw_error for each in runs)):.2f}",
        f"{min(each.clearance for each in runs):.3f}",
        str(sum(each.contacts for each in runs)),
    )
    return f"| {' | '.join(cells)} |\n"
