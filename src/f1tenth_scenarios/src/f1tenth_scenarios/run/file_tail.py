"""Following files that another process is still writing."""

import contextlib
from pathlib import Path

from f1tenth_judge.record.record import COLUMNS
from f1tenth_judge.run.log_excerpt import plain
from f1tenth_judge.run.so_far import SoFar


class LineTail:
    """Hands out each complete line of a growing file once."""

    def __init__(self, path: Path):
        self._path = path
        self._offset = 0
        self._rest = b""

    def new_lines(self) -> list[str]:
        """The lines completed since the last call; none while the file does not exist."""
        try:
            with open(self._path, "rb") as stream:
                stream.seek(self._offset)
                data = stream.read()
        except FileNotFoundError:
            return []
        self._offset += len(data)
        *lines, self._rest = (self._rest + data).split(b"\n")
        return [plain(line) for line in lines]


class RecordTail:
    """Hands what the simulator's record says to whoever follows the run."""

    _TIME, _CAR, _X, _Y, _YAW, _CONTACTS = map(COLUMNS.index, ("time", "car", "x", "y", "yaw", "contacts"))

    def __init__(self, path: Path, so_far: SoFar):
        self._tail = LineTail(path)
        self._so_far = so_far

    def poll(self) -> None:
        """Read what has been added."""
        for line in self._tail.new_lines():
            cells = line.split(",")
            if len(cells) == len(COLUMNS) and cells[self._TIME] != COLUMNS[self._TIME]:
                # A row that somebody has damaged is none; the evidence tells of it.
                with contextlib.suppress(ValueError):
                    self._take(cells)

    def _take(self, cells: list[str]) -> None:
        time, *place = (float(cells[each]) for each in (self._TIME, self._X, self._Y, self._YAW))
        self._so_far.take(time, cells[self._CAR], place, bool(cells[self._CONTACTS]))
