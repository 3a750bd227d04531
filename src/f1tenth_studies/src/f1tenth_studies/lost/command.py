"""The command `lost`."""

import argparse
import os
import shlex
import sys
from collections.abc import Iterator, Sequence
from typing import Optional

from f1tenth_scenarios.cli.exit_codes import BAD_INPUT, NOT_PASSED, PASSED
from f1tenth_scenarios.cli.options import expect_at_least
from f1tenth_scenarios.errors import ScenarioError

from f1tenth_scenarios import places
from f1tenth_studies.drives.options import add_options
from f1tenth_studies.drives.places import circuit_drives, track_drives
from f1tenth_studies.drives.pool import end_by_signals, outcomes
from f1tenth_studies.files import expect_folder_of, made_folder
from f1tenth_studies.lost.document import document
from f1tenth_studies.lost.trial import Found, Told, Trial, find, make_trial
from f1tenth_studies.table import made_by, publish

_CIRCUIT_LIMITS = {Told.TRUTH: 30.0, Told.NEAR: 5.0, Told.FAR: 5.0, Told.NOTHING: 10.0}  # s
_TRACK_LIMITS = {Told.NOTHING: 30.0}  # s


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run the command; returns the exit code: 1 when a car was not found in time."""
    parser = argparse.ArgumentParser(prog="lost", description="Drives, and tells how soon amcl knows where.")
    add_options(parser, circuits="0:19")
    options = parser.parse_args(arguments)
    end_by_signals()
    try:
        return _run(options, sys.argv[1:] if arguments is None else arguments)
    except ScenarioError as error:
        print(f"lost: {error}", file=sys.stderr)
        return BAD_INPUT


def _run(options: argparse.Namespace, arguments: Sequence[str]) -> int:
    expect_at_least(1, options.jobs, "--jobs")
    expect_folder_of(options.table, "--table")
    trials = list(_trials(options))
    if not trials:
        raise ScenarioError("no seeds given: nothing to drive")
    jobs = options.jobs or len(os.sched_getaffinity(0))
    found = [_said(each) for each in outcomes(find, trials, jobs)]
    made = made_by(shlex.join(["rosrun", "f1tenth_studies", "lost", *arguments]))
    publish(document(found, made), options.table)
    return PASSED if all(each.passed for each in found) else NOT_PASSED


def _trials(options: argparse.Namespace) -> Iterator[Trial]:
    folder = made_folder((options.results or places.results_root()).resolve() / "places" / "lost")
    of_places = [
        (list(circuit_drives(options.circuits)), _CIRCUIT_LIMITS),
        (list(track_drives(options.tracks, folder)), _TRACK_LIMITS),
    ]
    for drives, limits in of_places:
        for told, limit in limits.items():
            yield from (make_trial(drive, told, limit) for drive in drives)


def _said(found: Found) -> Found:
    drive, told = found.trial.drive, found.trial.told
    said = f"{drive.place}, seed {drive.seed}, told {told.words}: found after {found.after:.2f} s"
    print(f"lost: {said}", file=sys.stderr, flush=True)
    return found
