"""Following files that another process is still writing."""

from collections.abc import Mapping
from pathlib import Path
from typing import Optional

from f1tenth_judge.judge.false_start import FirstMoves
from f1tenth_judge.judge.progress import TaskProgress
from f1tenth_judge.record.record import COLUMNS
from f1tenth_judge.run.log_excerpt import plain


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
    """What the simulator's record says so far: cheap enough to be asked many times a second."""

    _TIME, _CAR, _X, _Y, _YAW, _CONTACTS = map(COLUMNS.index, ("time", "car", "x", "y", "yaw", "contacts"))

    def __init__(self, path: Path, progress: Mapping[str, TaskProgress]):
        """`progress` of the cars follows what is read."""
        self._tail = LineTail(path)
        self._progress = progress
        self.time: Optional[float] = None  # s, of the last period
        self.touches = 0  # rows with a contact
        self.moves = FirstMoves()

    def poll(self) -> None:
        """Read what has been added."""
        for line in self._tail.new_lines():
            cells = line.split(",")
            if len(cells) == len(COLUMNS) and cells[self._TIME] != COLUMNS[self._TIME]:
                self._take(cells)

    def _take(self, cells: list[str]) -> None:
        car = cells[self._CAR]
        self.time, x, y, yaw = (float(cells[each]) for each in (self._TIME, self._X, self._Y, self._YAW))
        self.touches += bool(cells[self._CONTACTS])
        self.moves.take(self.time, car, x, y)
        if car in self._progress:
            self._progress[car].take(self.time, x, y, yaw)
