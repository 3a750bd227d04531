"""What the report shows: read from a results folder."""

import dataclasses
import os
import urllib.parse
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.files import (
    BAG_FILE,
    JUNIT_FILE,
    PICTURE_FILE,
    PREVIOUS_FOLDER,
    REPLAY_FILE,
    RESULT_FILE,
    TRAJECTORY_FILE,
)
from f1tenth_judge.record.record import Record, read_record
from f1tenth_judge.record.replay import Replay, read_replay
from f1tenth_judge.report.replay_columns import pack_run, pack_tracks, pack_world, thumbnail
from f1tenth_judge.results.result_file import read_result

_LINKS = {
    "log": "log",
    "bag": BAG_FILE,
    "result": RESULT_FILE,
    "JUnit": JUNIT_FILE,
    "trajectory": TRAJECTORY_FILE,
    "picture": PICTURE_FILE,
}


@dataclasses.dataclass(frozen=True)
class RunContent:
    """One row of the table and what opens from it."""

    # result.json, `thumbnail`, `links`, `problems` and `previous` (the other run's result.json or nothing)
    summary: dict[str, Any]
    replay: str  # packed, as the others
    world: str
    previous: Optional[str]


def read_results(folder: Path, beside: Path, against: Optional[Path] = None) -> Iterator[RunContent]:
    """All runs of a results folder, in the order of their names; what cannot be read is among the problems.

    Args:
        folder: with a folder per scenario
        beside: folder that links are relative to
        against: another results folder to compare with; default: the run before, which each folder keeps

    Raises:
        ScenarioError: there is no run.
    """
    files = sorted(folder.glob(f"*/{RESULT_FILE}"))
    if not files:
        raise ScenarioError(f"{folder}: no results; a run writes NAME/{RESULT_FILE} there")
    for file in files:
        run = file.parent
        yield _Reader(run, against / run.name if against else run / PREVIOUS_FOLDER).read(beside)


class _Reader:
    """Reads one run; what is broken is left out and named."""

    def __init__(self, folder: Path, previous: Path):
        self._folder, self._previous = folder, previous
        self._problems: list[str] = []

    def read(self, beside: Path) -> RunContent:
        result = self._try(_read_result, self._folder) or _unknown_result(self._folder.name)
        record = self._try(read_record, self._folder / TRAJECTORY_FILE) or Record({})
        replay = self._try(read_replay, self._folder / REPLAY_FILE) or Replay()
        other = self._previous
        compared = self._try(_read_result, other) if (other / RESULT_FILE).is_file() else None
        # A run that drove the same, bit for bit, could not be seen beside it.
        differs = compared and compared.get("trajectory_hash") != result.get("trajectory_hash")
        before = self._try(read_record, other / TRAJECTORY_FILE) if differs else None
        summary = {
            **result,
            "thumbnail": thumbnail(record),
            "links": _links(self._folder, beside),
            "previous": compared,
            "problems": self._problems,
        }
        return RunContent(
            summary,
            pack_run(record, replay),
            pack_world(replay),
            pack_tracks(before, replay.road) if before else None,
        )

    def _try(self, read, path: Path):
        try:
            return read(path)
        except ScenarioError as error:
            self._problems.append(str(error))
            return None


def _read_result(folder: Path) -> dict[str, Any]:
    return read_result(folder / RESULT_FILE)


def _unknown_result(name: str) -> dict[str, Any]:
    reason = f"{RESULT_FILE} cannot be read"
    return {"scenario": name, "verdict": "unknown", "passed": False, "reason": reason, "criteria": []}


def _links(folder: Path, beside: Path) -> dict[str, str]:
    return {
        name: urllib.parse.quote(os.path.relpath(folder / file, beside))
        for name, file in _LINKS.items()
        if (folder / file).exists()
    }
