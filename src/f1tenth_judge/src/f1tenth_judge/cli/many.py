"""Runs of sweep, suite and league."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Callable

from f1tenth_judge.cli.exit_codes import exit_code
from f1tenth_judge.cli.options import expect_at_least
from f1tenth_judge.stop_request import StopRequest

if TYPE_CHECKING:
    from f1tenth_judge.batch.sweep import Sweep


def check_many(options) -> None:
    """Refuse numbers that make no sense.

    Raises:
        ScenarioError: --jobs or --repeat.
    """
    expect_at_least(1, options.workers, "--jobs")
    expect_at_least(2, options.repeat, "--repeat")


def run_many(sweep: "Sweep", title: str, folder: Path, options, write: Callable[[], str]) -> int:
    """Run all that has no result yet, and tell what went wrong; watchers see it while it goes on.

    Args:
        sweep: what is run
        title: of the page of watchers
        folder: of the results
        options: of the command
        write: makes something of the results, and answers which of its files in the folder the watchers get

    Returns:
        The exit code: whether each run has a result, and each of a case the same one.
    """
    from f1tenth_judge.report.live.watching import watched_jobs

    with StopRequest().listening() as stop, watched_jobs(sweep.jobs, title, folder, options.watch) as lead_to:
        sweep.run(stop, options.workers, options.scheduler)
        # Runs that were told to stop have no result, and nothing is wrong with that.
        for problem in [] if stop.signal else sweep.problems:
            print(f"f1tenth: {problem}", file=sys.stderr)
        if sweep.reused:
            print(f"{'reused:':19}{len(sweep.reused)} of {len(sweep.jobs)}, of the same inputs")
        if options.repeat:
            same = len(sweep.plans) - len(sweep.unsteady)
            print(f"{'repeated:':19}{options.repeat} times each, {same} of {len(sweep.plans)} repeatable")
        if sweep.results:
            lead_to(f"/{write()}")
    return exit_code(len(sweep.results) == len(sweep.jobs) and not sweep.unsteady, stop)
