"""Many drives at a time, each in a process of its own."""

import concurrent.futures
import multiprocessing
import signal
from collections.abc import Iterator, Sequence
from typing import Any, Callable

from f1tenth_scenarios.errors import ScenarioError

_ENDINGS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def end_by_signals() -> None:
    """Let a signal end this process, and the drives with it."""
    for each in _ENDINGS:
        signal.signal(each, _end)


def outcomes(function: Callable[[Any], Any], drives: Sequence[Any], jobs: int) -> Iterator[Any]:
    """The outcome of each drive, in their order.

    Raises:
        ScenarioError: what a drive raises, or its process was killed; no further drive is begun.
    """
    # Not spawned: they would find the modules of the source tree, which lack what was compiled.
    context = multiprocessing.get_context("fork")
    pool = concurrent.futures.ProcessPoolExecutor(jobs, context, _let_the_first_end_this)
    try:
        for each in [pool.submit(function, drive) for drive in drives]:
            yield each.result()
    except concurrent.futures.BrokenExecutor as error:
        raise ScenarioError("the process of a drive was killed; is there enough memory?") from error
    except SystemExit:
        for child in multiprocessing.active_children():
            child.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _end(number: int, _) -> None:
    raise SystemExit(128 + number)


def _let_the_first_end_this() -> None:
    for each in _ENDINGS:
        signal.signal(each, signal.SIG_DFL)
    # Ctrl-C reaches all processes of a terminal.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
