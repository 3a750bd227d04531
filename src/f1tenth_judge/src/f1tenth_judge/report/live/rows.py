"""A record that is written for the watchers alone."""

import csv
import os
from pathlib import Path
from typing import Any, Optional, TextIO

from f1tenth_judge.record.row import COLUMNS


class Rows:
    """Writes the columns that are known, at once."""

    def __init__(self, file: Path):
        """Write nothing yet."""
        self._file = file
        self._stream: Optional[TextIO] = None

    def begin(self) -> None:
        """Begin anew, with a file of its own, by which the other side knows."""
        self.close()
        self._stream = self._file.with_name("next.csv").open("w", encoding="utf-8", newline="")
        os.replace(self._stream.name, self._file)
        self._writer = csv.writer(self._stream, lineterminator="\n")
        self._writer.writerow(COLUMNS)

    def write(self, time: float, car: str, **known: Any) -> None:
        """A row of a car at a time (s); `known`: some of the columns of a record."""
        row = {"time": time, "car": car, **known}
        self._writer.writerow([row.get(name, "") for name in COLUMNS])

    def flush(self) -> None:
        """Let the watchers have what is written."""
        assert self._stream
        self._stream.flush()

    def close(self) -> None:
        """Write no more."""
        if self._stream:
            self._stream.close()
