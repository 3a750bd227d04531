"""What all commands that drive have in common: options, table, exit code."""

import argparse
import os
import shlex
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Callable, Optional

from f1tenth_scenarios.cli.exit_codes import BAD_INPUT, NOT_PASSED, PASSED
from f1tenth_scenarios.cli.options import expect_at_least
from f1tenth_scenarios.errors import ScenarioError

from f1tenth_scenarios import places
from f1tenth_studies.drives.pool import end_by_signals
from f1tenth_studies.files import expect_folder_of, made_folder
from f1tenth_studies.table import made_by, publish

Drives = Callable[[argparse.Namespace, Path], Sequence[Any]]
"""Drives as the options say, with a folder for places that are made; returns the outcomes (`passed`)."""


def run_command(
    parser: argparse.ArgumentParser,
    drives: Drives,
    document: Callable[[Sequence[Any], str], str],
    arguments: Optional[Sequence[str]],
) -> int:
    """Read a command's arguments, drive, and publish the document.

    Args:
        parser: with the command's name and its own options
        drives: as of Drives
        document: makes the text from the outcomes, and from how and where they were made
        arguments: those of the command line; default: of this process

    Returns:
        The exit code: NOT_PASSED when an outcome was not good enough.
    """
    _add_options(parser)
    options = parser.parse_args(arguments)
    end_by_signals()
    try:
        expect_at_least(1, options.jobs, "--jobs")
        expect_folder_of(options.table, "--table")
        options.jobs = options.jobs or len(os.sched_getaffinity(0))
        results = (options.results or places.results_root()).resolve()
        driven = drives(options, made_folder(results / "places" / parser.prog))
        if not driven:
            raise ScenarioError("no seeds given: nothing to drive")
        given = sys.argv[1:] if arguments is None else arguments
        made = made_by(shlex.join(["rosrun", "f1tenth_studies", parser.prog, *given]))
        publish(document(driven, made), options.table)
    except ScenarioError as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return BAD_INPUT
    return PASSED if all(each.passed for each in driven) else NOT_PASSED


def _add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--tracks", default="0:1", metavar="SEEDS", help="of each track, in both directions (%(default)s)"
    )
    parser.add_argument(
        "--table", type=Path, metavar="FILE", help="write the table there, too; what is below it stays"
    )
    parser.add_argument("--results", type=Path, metavar="FOLDER", help="default: results of the workspace")
    parser.add_argument("--jobs", type=int, metavar="N", help="drives at a time; default: one per core")
