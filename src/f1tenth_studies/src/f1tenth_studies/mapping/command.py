"""The command `maps`."""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Optional

from f1tenth_studies.drives.command import run_command
from f1tenth_studies.drives.drive import Drive
from f1tenth_studies.drives.places import circuit_drives, road_drives, track_drives
from f1tenth_studies.drives.pool import outcomes
from f1tenth_studies.mapping.document import document
from f1tenth_studies.mapping.drive import Mapped, map_drive


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run the command; returns the exit code: 1 when a map was not good enough."""
    parser = argparse.ArgumentParser(prog="maps", description="Drives around, and judges the maps of it.")
    parser.add_argument("--circuits", default="0:5", metavar="SEEDS", help="of each circuit (%(default)s)")
    parser.add_argument("--roads", default="0:19", metavar="SEEDS", help="of make_road (%(default)s)")
    return run_command(parser, _maps, document, arguments)


def _maps(options: argparse.Namespace, folder: Path) -> list[Mapped]:
    drives = [
        *circuit_drives(options.circuits),
        *track_drives(options.tracks, folder),
        *road_drives(options.roads, folder),
    ]
    return _mapped(drives, options.jobs)


def _mapped(drives: Sequence[Drive], jobs: int) -> list[Mapped]:
    """The outcome of each drive, in their order."""
    return [_said(each) for each in outcomes(map_drive, drives, jobs)]


def _said(mapped: Mapped) -> Mapped:
    drive, check = mapped.drive, mapped.check
    shares = f"{100 * check.cells_near_walls:.1f} %, {100 * check.walls_near_cells:.1f} %"
    said = "; ".join(filter(None, [shares, mapped.problem]))
    print(f"maps: {drive.place}, seed {drive.seed}: {said}", file=sys.stderr, flush=True)
    return mapped
