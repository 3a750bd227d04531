"""Names of the files in the folder of a run, and of the report on many."""

import errno
import json
import os
import stat
from pathlib import Path
from typing import Any, BinaryIO

RESULT_FILE, JUNIT_FILE = "result.json", "junit.xml"
TRAJECTORY_FILE, PICTURE_FILE = "trajectory.csv", "trajectory.png"
REPLAY_FILE, BAG_FILE = "replay.json.gz", "run.bag"
RUN_FILES = (RESULT_FILE, JUNIT_FILE, TRAJECTORY_FILE, PICTURE_FILE, REPLAY_FILE, BAG_FILE)
DRAWINGS_FILE = "drawings.jsonl"  # in the log folder
PREVIOUS_FOLDER = "previous"
REPORT_FILE, PAGE_FILE = "report.html", "index.html"  # the second: of tables of a suite or league


def reading(path: Path) -> BinaryIO:
    """Open a file of a run. A planner may have put a pipe or a device in its place, which would never end.

    Raises:
        FileNotFoundError: there is no file of that name.
        OSError: it cannot be opened.
    """
    descriptor = os.open(path, os.O_RDONLY | os.O_CLOEXEC | os.O_NONBLOCK)
    if not stat.S_ISREG(os.fstat(descriptor).st_mode):
        is_folder = stat.S_ISDIR(os.fstat(descriptor).st_mode)
        os.close(descriptor)
        code = errno.EISDIR if is_folder else errno.ENOENT
        raise OSError(code, os.strerror(code), str(path))
    return os.fdopen(descriptor, "rb")


def read_json(path: Path) -> dict[str, Any]:
    """What a JSON file holds; empty when it is missing or broken."""
    try:
        with reading(path) as stream:
            return json.load(stream)
    except (OSError, ValueError):
        return {}
