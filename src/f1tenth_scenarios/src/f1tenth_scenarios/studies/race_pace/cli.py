"""The commands `race_reference` and `race_pace`."""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Callable, Optional

from f1tenth_scenarios import places
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.results.reference_laps import reference_laps_text
from f1tenth_scenarios.studies.race_pace.laps import drive
from f1tenth_scenarios.studies.race_pace.limits import CLEARANCE, read_limits
from f1tenth_scenarios.studies.race_pace.reference import Reference, compute_reference, write_raceline
from f1tenth_scenarios.studies.race_pace.table import Comparison, make_table
from f1tenth_scenarios.studies.race_pace.track import load_track

CIRCUITS = ("circuit1", "circuit2", "circuit3", "circuit4", "circuit5")
LAPS = 20

# Exit codes.
GOOD, TOO_SLOW, BAD_INPUT = 0, 1, 2


def reference_main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run `race_reference`; returns the exit code."""
    parser = argparse.ArgumentParser(
        prog="race_reference", description="Computes the fastest lap of circuits for the simulator's car."
    )
    add_circuits(parser, "circuit, or centreline file X_centerline.csv")
    parser.add_argument(
        "--clearance", type=float, default=CLEARANCE, metavar="M", help="beside the car (%(default)s)"
    )
    parser.add_argument("-o", "--output", type=Path, metavar="FOLDER", help="write NAME_raceline.csv there")
    parser.add_argument("--laps", type=Path, metavar="FILE", help="write the lap times there, as YAML")
    return guarded(parser.prog, _references, parser.parse_args(arguments))


def pace_main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run `race_pace`; returns the exit code: 1 when a lap was too slow or too close to a wall."""
    parser = argparse.ArgumentParser(
        prog="race_pace", description="Drives flying laps and compares them with the fastest lap possible."
    )
    add_circuits(parser, "circuit")
    parser.add_argument("--laps", type=int, default=LAPS, metavar="N", help="flying laps (%(default)s)")
    parser.add_argument("--table", type=Path, metavar="FILE", help="write the table there, too")
    parser.add_argument("--results", type=Path, metavar="FOLDER", help="default: results/race_pace")
    options = parser.parse_args(arguments)
    if options.laps < 1:
        parser.error(f"--laps: found {options.laps}, must be at least 1")
    return guarded(parser.prog, _compare, options)


def add_circuits(parser: argparse.ArgumentParser, text: str) -> None:
    """Let a command take names; `text` says of what."""
    parser.add_argument(
        "names", nargs="*", default=CIRCUITS, metavar="NAME", help=f"{text}; default: all five"
    )


def guarded(program: str, action: Callable, options) -> int:
    """Run an action; print the user's mistake as one line. Returns the exit code."""
    try:
        return action(options)
    except ScenarioError as error:
        print(f"{program}: {error}", file=sys.stderr)
        return BAD_INPUT


def _references(options) -> int:
    limits = read_limits(options.clearance)
    laps = {}
    for name in options.names:
        reference = compute_reference(load_track(name), limits)
        laps[name] = reference.lap_time
        print(_describe(name, reference), flush=True)
        if options.output:
            stem = Path(name).stem.removesuffix("_centerline")
            write_raceline(options.output / f"{stem}_raceline.csv", reference, limits)
    if options.laps:
        write_table(options.laps, reference_laps_text(laps))
    return GOOD


def _describe(name: str, reference: Reference) -> str:
    low, high = reference.speed.min(), reference.speed.max()
    return f"{name}: {reference.lap_time:.3f} s, {reference.s[-1]:.1f} m, {low:.1f} to {high:.1f} m/s"


def _compare(options) -> int:
    limits = read_limits()
    folder = (options.results or places.results_folder("race_pace")).resolve()
    references = {name: compute_reference(load_track(name), limits).lap_time for name in options.names}
    comparisons = [Comparison(drive(name, options.laps, folder), references[name]) for name in options.names]
    table = make_table(comparisons, limits)
    print(table)
    if options.table:
        write_table(options.table, table)
    problems = [problem for each in comparisons if (problem := each.problem(options.laps))]
    for problem in problems:
        print(f"race_pace: {problem}", file=sys.stderr)
    return TOO_SLOW if problems else GOOD


def write_table(path: Path, text: str) -> None:
    """Write a document.

    Raises:
        ScenarioError: it cannot be written.
    """
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        raise ScenarioError(f"{path}: cannot be written: {error.strerror}") from error
