"""Following files that another process is still writing."""

import contextlib
from pathlib import Path

from f1tenth_judge.record.files import reading
from f1tenth_judge.record.row import cells_of, row_of
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
            with reading(self._path) as stream:
                stream.seek(self._offset)
                data = stream.read()
        except OSError:  # the evidence tells of what was put there
            return []
        self._offset += len(data)
        *lines, self._rest = (self._rest + data).split(b"\n")
        return [plain(line) for line in lines]


class RecordTail:
    """Hands what the simulator's record says to whoever follows the run."""

    def __init__(self, path: Path, so_far: SoFar):
        self._tail = LineTail(path)
        self._so_far = so_far

    def poll(self) -> None:
        """Read what has been added."""
        for line in self._tail.new_lines():
            # The heads of the columns, or a row that somebody has damaged: the evidence tells of that.
            with contextlib.suppress(ValueError):
                row = row_of(cells_of(line))
                self._so_far.take(row.time, row.car, (row.x, row.y, row.yaw), bool(row.contacts))
