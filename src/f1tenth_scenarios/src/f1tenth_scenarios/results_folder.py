"""The folder that a run writes to: its own as long as it runs, and free of earlier results."""

import contextlib
import fcntl
import shutil
from collections.abc import Iterator
from pathlib import Path

from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.result import PICTURE_FILE, RESULT_FILE, TRAJECTORY_FILE


@contextlib.contextmanager
def claimed(folder: Path, log_folder: Path) -> Iterator[None]:
    """Keep other runs out while the block runs; earlier results are gone, log_folder is there and empty.

    Raises:
        ScenarioError: the folder cannot be used, or another run is using it.
    """
    with contextlib.ExitStack() as stack:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            lock = stack.enter_context(open(folder / ".lock", "w", encoding="utf-8"))
        except OSError as error:
            raise ScenarioError(f"{folder}: cannot write results: {error.strerror}") from error
        _lock(folder, lock)
        _clear(folder, log_folder)
        yield


def _lock(folder, lock):
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        raise ScenarioError(f"{folder}: another run is writing its results there") from error


def _clear(folder, log_folder):
    for name in (RESULT_FILE, TRAJECTORY_FILE, PICTURE_FILE):
        (folder / name).unlink(missing_ok=True)
    shutil.rmtree(log_folder, ignore_errors=True)
    log_folder.mkdir()
