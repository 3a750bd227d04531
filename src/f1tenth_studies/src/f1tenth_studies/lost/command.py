"""The command `lost`."""

import argparse
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Optional

from f1tenth_studies.drives.command import run_command
from f1tenth_studies.drives.places import circuit_drives, track_drives
from f1tenth_studies.drives.pool import outcomes
from f1tenth_studies.lost.document import document
from f1tenth_studies.lost.trial import Found, Told, Trial, find, make_trial

_CIRCUIT_LIMITS = {Told.TRUTH: 30.0, Told.NEAR: 5.0, Told.FAR: 5.0, Told.NOTHING: 10.0}  # s
_TRACK_LIMITS = {Told.NOTHING: 30.0}  # s


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run the command; returns the exit code: 1 when a car was not found in time."""
    parser = argparse.ArgumentParser(prog="lost", description="Drives, and tells how soon amcl knows where.")
    parser.add_argument("--circuits", default="0:19", metavar="SEEDS", help="of each circuit (%(default)s)")
    return run_command(parser, _found, document, arguments)


def _found(options: argparse.Namespace, folder: Path) -> list[Found]:
    trials = list(_trials(options, folder))
    return [_said(each) for each in outcomes(find, trials, options.jobs)]


def _trials(options: argparse.Namespace, folder: Path) -> Iterator[Trial]:
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
