"""The record of a run that the judge simulates itself: a planner finds the file, and could write to it."""

import csv
import hashlib
import io
import os
from pathlib import Path

from f1tenth_judge.record.files import reading


class OwnRecord:
    """A file of rows, open while it is a context, that knows what was written to it."""

    def __init__(self, path: Path):
        self._path = path
        self._digest = hashlib.sha256()

    def __enter__(self) -> "OwnRecord":
        # Appending, so that it writes over nothing that somebody else has added.
        self._path.write_bytes(b"")
        self._file = open(self._path, "ab", buffering=0)
        self._identity = os.fstat(self._file.fileno())
        return self

    def __exit__(self, *exception) -> None:
        self._file.close()

    def write(self, rows) -> None:
        """Add rows of values."""
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows(rows)
        data = text.getvalue().encode()
        self._digest.update(data)
        self._file.write(data)

    def problem(self) -> str:
        """What somebody else did to the file, in words; empty if nothing."""
        try:
            with reading(self._path) as stream:
                if not os.path.samestat(os.fstat(stream.fileno()), self._identity):
                    return self._was("replaced")
                same = hashlib.sha256(stream.read()).digest() == self._digest.digest()
                return "" if same else self._was("overwritten")
        except OSError:
            return self._was("removed")

    def _was(self, what: str) -> str:
        return f"{self._path} was {what} while the run went on"
