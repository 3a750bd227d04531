"""What the report says: read from a results folder."""

import dataclasses
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Optional

from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.record.record import read_record
from f1tenth_scenarios.record.replay import REPLAY_FILE, read_replay
from f1tenth_scenarios.report.packing import Packed
from f1tenth_scenarios.report.replay_columns import pack_run, pack_tracks, thumbnail
from f1tenth_scenarios.results.result import RESULT_FILE, TRAJECTORY_FILE
from f1tenth_scenarios.results.results_folder import PREVIOUS_FOLDER


@dataclasses.dataclass(frozen=True)
class RunContent:
    """One row of the table and what opens behind it."""

    summary: dict[
        str, Any
    ]  # result.json, with `thumbnail` and `previous` (the other run's result.json or nothing)
    replay: Packed
    previous: Optional[Packed]


def read_results(folder: Path, against: Optional[Path] = None) -> Iterator[RunContent]:
    """All runs of a results folder, in the order of their names.

    Args:
        folder: with a folder a scenario
        against: another results folder to compare with; default: the run before, which each folder keeps

    Raises:
        ScenarioError: there is no run, or a file is broken.
    """
    files = sorted(folder.glob(f"*/{RESULT_FILE}"))
    if not files:
        raise ScenarioError(f"{folder}: no results; a run writes NAME/{RESULT_FILE} there")
    for file in files:
        run = file.parent
        yield _read_run(run, against / run.name if against else run / PREVIOUS_FOLDER)


def _read_run(folder: Path, previous: Path) -> RunContent:
    record = read_record(folder / TRAJECTORY_FILE)
    compared = (previous / RESULT_FILE).is_file()
    summary = {
        **_read_result(folder),
        "thumbnail": thumbnail(record),
        "previous": _read_result(previous) if compared else None,
    }
    return RunContent(
        summary,
        pack_run(record, read_replay(folder / REPLAY_FILE)),
        pack_tracks(read_record(previous / TRAJECTORY_FILE)) if compared else None,
    )


def _read_result(folder: Path) -> dict[str, Any]:
    file = folder / RESULT_FILE
    try:
        result = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ScenarioError(f"{file}: not a result: {error}") from error
    if not isinstance(result, dict) or "verdict" not in result:
        raise ScenarioError(f"{file}: not a result: it has no verdict")
    return result
