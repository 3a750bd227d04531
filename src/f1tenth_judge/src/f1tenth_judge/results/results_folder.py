"""The folder that a run writes to: its own while it runs; earlier results stay until there are new ones."""

import contextlib
import fcntl
import shutil
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.record.files import PREVIOUS_FOLDER, RESULT_FILE, RUN_FILES, read_json

INTERRUPTED_FOLDER = "interrupted"
_EARLIER_LOG, _EARLIER = ".earlier_log", ".earlier"


@contextlib.contextmanager
def claimed(folder: Path, log_folder: Path, commits: Mapping[str, Any]) -> Iterator["ResultsFolder"]:
    """Keep other runs out while the block runs; log_folder is there and empty.

    If no final result is written, everything is as it was before, and what was written to log_folder is in
    the folder `interrupted`.

    Args:
        folder: for the results
        log_folder: for what processes write
        commits: of the run, as `versions.commits` gives them

    Raises:
        ScenarioError: the folder cannot be used, or another run is using it.
    """
    with contextlib.ExitStack() as stack:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            lock = stack.enter_context(open(folder / ".lock", "w", encoding="utf-8"))
            _lock(folder, lock)
            claim = stack.enter_context(contextlib.closing(ResultsFolder(folder, log_folder, commits)))
        except OSError as error:
            raise ScenarioError(f"{folder}: cannot write results: {error.strerror}") from error
        yield claim


class ResultsFolder:
    """A results folder in which a run is in progress."""

    def __init__(self, folder: Path, log_folder: Path, commits: Mapping[str, Any]):
        self._folder, self._log, self._commits = folder, log_folder, commits
        self._earlier_log, self._earlier = folder / _EARLIER_LOG, folder / _EARLIER
        self._end_run()  # one that was killed
        if self._log.exists():
            self._log.rename(self._earlier_log)
        self._log.mkdir()

    def place_of_results(self) -> Path:
        """Where the results of a run that came to its end are to be written.

        When they are, earlier ones are in the folder `previous` if they are of another commit than ours (or
        of a working copy with changes, which may be anything), be it of the workspace or of a driver.

        Raises:
            ScenarioError: earlier results cannot be moved.
        """
        with writing(self._folder):
            _move(RUN_FILES, self._folder, _emptied(self._earlier))
            _move([_EARLIER_LOG], self._folder, self._earlier)
        return self._folder

    def place_of_interrupted(self) -> Path:
        """Where the results of a run that was told to stop are to be written."""
        return _emptied(self._folder / INTERRUPTED_FOLDER)

    def close(self) -> None:
        """The run is over."""
        with writing(self._folder):
            if not self._has_result():
                self._keep_interrupted_log()
            self._end_run()

    def _keep_interrupted_log(self) -> None:
        interrupted = self._folder / INTERRUPTED_FOLDER
        interrupted.mkdir(exist_ok=True, parents=True)
        shutil.rmtree(interrupted / self._log.name, ignore_errors=True)
        with contextlib.suppress(FileNotFoundError):  # somebody removed it
            self._log.rename(interrupted / self._log.name)

    def _has_result(self) -> bool:
        """Whether there is one of the run in progress: earlier results are out of its way by then."""
        return self._earlier.exists() and (self._folder / RESULT_FILE).exists()

    def _end_run(self) -> None:
        """Let earlier results go, or come back."""
        if self._has_result():
            shutil.rmtree(self._earlier / _EARLIER_LOG, ignore_errors=True)
            result = self._earlier / RESULT_FILE
            if result.exists() and _is_other(_commits_of(result), self._commits):
                previous = self._folder / PREVIOUS_FOLDER
                shutil.rmtree(previous, ignore_errors=True)
                self._earlier.rename(previous)
        else:
            _move([*RUN_FILES, _EARLIER_LOG], self._earlier, self._folder)
            if self._earlier_log.exists():
                shutil.rmtree(self._log, ignore_errors=True)
                self._earlier_log.rename(self._log)
        shutil.rmtree(self._earlier, ignore_errors=True)


def _lock(folder, lock):
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        raise ScenarioError(f"{folder}: another run is writing its results there") from error


def _emptied(folder: Path) -> Path:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)  # a planner may have removed the whole
    return folder


def _move(names: Iterable[str], source: Path, target: Path) -> None:
    for name in names:
        with contextlib.suppress(FileNotFoundError):
            (source / name).rename(target / name)


def _is_other(one: Mapping[str, Any], other: Mapping[str, Any]) -> bool:
    known = [one["commit"], *one["driver_commits"].values()] if one == other else [None]
    return any(each is None or each.endswith("-dirty") for each in known)


def _commits_of(path: Path) -> dict[str, Any]:
    with contextlib.suppress(KeyError, TypeError):
        versions = read_json(path)["versions"]
        return {key: versions[key] for key in ("commit", "driver_commits")}
    return {}
