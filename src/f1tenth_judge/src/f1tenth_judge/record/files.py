"""Names of the files in the folder of a run, and of the report on many."""

import json
from pathlib import Path
from typing import Any

RESULT_FILE, JUNIT_FILE = "result.json", "junit.xml"
TRAJECTORY_FILE, PICTURE_FILE = "trajectory.csv", "trajectory.png"
REPLAY_FILE, BAG_FILE = "replay.json.gz", "run.bag"
RUN_FILES = (RESULT_FILE, JUNIT_FILE, TRAJECTORY_FILE, PICTURE_FILE, REPLAY_FILE, BAG_FILE)
DRAWINGS_FILE = "drawings.jsonl"  # in the log folder
PREVIOUS_FOLDER = "previous"
REPORT_FILE, PAGE_FILE = "report.html", "index.html"  # the second: of tables of a suite or league


def read_json(path: Path) -> dict[str, Any]:
    """What a JSON file holds; empty when it is missing or broken."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
