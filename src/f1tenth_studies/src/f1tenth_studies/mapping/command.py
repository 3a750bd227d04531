"""The command `maps`."""

import argparse
import os
import shlex
import sys
from collections.abc import Sequence
from typing import Optional

from f1tenth_scenarios.cli.exit_codes import BAD_INPUT, NOT_PASSED, PASSED
from f1tenth_scenarios.cli.options import expect_at_least
from f1tenth_scenarios.errors import ScenarioError

from f1tenth_scenarios import places
from f1tenth_studies.drives.drive import Drive
from f1tenth_studies.drives.options import add_options
from f1tenth_studies.drives.places import circuit_drives, road_drives, track_drives
from f1tenth_studies.drives.pool import end_by_signals, outcomes
from f1tenth_studies.files import expect_folder_of, made_folder
from f1tenth_studies.mapping.document import document
from f1tenth_studies.mapping.drive import Mapped, map_drive
from f1tenth_studies.table import made_by, publish


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run the command; returns the exit code: 1 when a map was not good enough."""
    parser = argparse.ArgumentParser(prog="maps", description="Drives around, and judges the maps of it.")
    add_options(parser, circuits="0:5")
    parser.add_argument("--roads", default="0:19", metavar="SEEDS", help="of make_road (%(default)s)")
    options = parser.parse_args(arguments)
    end_by_signals()
    try:
        return _run(options, sys.argv[1:] if arguments is None else arguments)
    except ScenarioError as error:
        print(f"maps: {error}", file=sys.stderr)
        return BAD_INPUT


def _run(options: argparse.Namespace, arguments: Sequence[str]) -> int:
    expect_at_least(1, options.jobs, "--jobs")
    expect_folder_of(options.table, "--table")
    mapped = _mapped(_drives(options), options.jobs or len(os.sched_getaffinity(0)))
    made = made_by(shlex.join(["rosrun", "f1tenth_studies", "maps", *arguments]))
    publish(document(mapped, made), options.table)
    return PASSED if all(each.passed for each in mapped) else NOT_PASSED


def _drives(options: argparse.Namespace) -> list[Drive]:
    folder = made_folder((options.results or places.results_root()).resolve() / "places" / "maps")
    drives = [
        *circuit_drives(options.circuits),
        *track_drives(options.tracks, folder),
        *road_drives(options.roads, folder),
    ]
    if not drives:
        raise ScenarioError("no seeds given: nothing to drive")
    return drives


def _mapped(drives: Sequence[Drive], jobs: int) -> list[Mapped]:
    """What came of each drive, in their order."""
    return [_said(each) for each in outcomes(map_drive, drives, jobs)]


def _said(mapped: Mapped) -> Mapped:
    drive, check = mapped.drive, mapped.check
    shares = f"{100 * check.cells_near_walls:.1f} %, {100 * check.walls_near_cells:.1f} %"
    said = "; ".join(filter(None, [shares, mapped.problem]))
    print(f"maps: {drive.place}, seed {drive.seed}: {said}", file=sys.stderr, flush=True)
    return mapped
