"""The folder that a run writes to: its own while it runs, with the commit before's results kept aside."""

import contextlib
import fcntl
import json
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Optional

from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.record.replay import REPLAY_FILE
from f1tenth_scenarios.results.result import PICTURE_FILE, RESULT_FILE, TRAJECTORY_FILE

PREVIOUS_FOLDER = "previous"
_FILES = (RESULT_FILE, TRAJECTORY_FILE, PICTURE_FILE, REPLAY_FILE)


@contextlib.contextmanager
def claimed(folder: Path, log_folder: Path, commit: Optional[str]) -> Iterator[None]:
    """Keep other runs out while the block runs; log_folder is there and empty.

    Earlier results are gone, or in the folder `previous` if they are of another commit than `commit` (or of a
    working copy with changes, which may be any).

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
        _clear(folder, commit)
        shutil.rmtree(log_folder, ignore_errors=True)
        log_folder.mkdir()
        yield


def _lock(folder, lock):
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        raise ScenarioError(f"{folder}: another run is writing its results there") from error


def _clear(folder, commit):
    if (folder / RESULT_FILE).exists() and _is_other(_commit_of(folder / RESULT_FILE), commit):
        _keep(folder)
    for name in _FILES:
        (folder / name).unlink(missing_ok=True)


def _keep(folder):
    previous = folder / PREVIOUS_FOLDER
    shutil.rmtree(previous, ignore_errors=True)
    previous.mkdir()
    for name in _FILES:
        with contextlib.suppress(FileNotFoundError):
            (folder / name).rename(previous / name)


def _is_other(one: Optional[str], other: Optional[str]) -> bool:
    return one is None or one != other or one.endswith("-dirty")


def _commit_of(path: Path) -> Optional[str]:
    try:
        return json.loads(path.read_text(encoding="utf-8"))["versions"]["commit"]
    except (OSError, ValueError, KeyError, TypeError):
        return None
