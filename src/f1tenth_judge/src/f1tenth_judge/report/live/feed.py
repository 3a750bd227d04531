"""What watchers are told of a run: read from the files that the simulator writes."""

import dataclasses
import math
import os
import time
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.interventions import read_interventions
from f1tenth_judge.record.record import COLUMNS, STAMP_EPSILON

_STEP = 0.05  # s, between two rows of a car that are told
_MOST_ROWS = 1000  # of a car, in one message: who is farther behind gets every n-th
# Of a car, as those in live.js: then the older half loses every second one, so that a run may go on for days.
_KEPT_ROWS = 20_000
_KEPT_EVENTS = 1000  # the latest
_CLOCKS = 0.1  # s, by which the time of a file may be behind the clock, and more than enough
_SHOWN = [COLUMNS.index(name) for name in ("time", "x", "y", "yaw", "v_x", "steering_angle", "clearance")]
_CAR, _CONTACTS = COLUMNS.index("car"), COLUMNS.index("contacts")


@dataclasses.dataclass
class Place:
    """How much of a feed a watcher has been told."""

    beginning: int = -1  # which run of the simulation it belongs to
    told: dict[str, float] = dataclasses.field(default_factory=dict)  # time of the last row (s), by car
    events: int = 0


class Feed:
    """Rows and events of a run, in memory once for all watchers. Not for several threads at once."""

    def __init__(self, record: Path, interventions: Path, since: Optional[float] = None):
        """`since`: when (Unix time, s) nothing of this run was written yet; none: now."""
        self._record, self._interventions = record, interventions
        self._since = time.time() - _CLOCKS if since is None else since
        self._beginning = 0
        self._clear()

    def _clear(self) -> None:
        self._file: Optional[int] = None  # inode
        self._offset, self._rest = 0, b""
        self._noted, self._noted_size = 0, 0  # interventions, and bytes of their file
        self._forget()

    def _forget(self) -> None:
        self._beginning += 1
        self._rows: dict[str, list[list[float]]] = {}
        self._touching: dict[str, str] = {}
        self._events: list[dict[str, Any]] = []
        self._forgotten = 0  # events

    def poll(self) -> bool:
        """Read what has been written since the last call; returns whether there was anything."""
        lines = self._new_lines()
        for line in lines:
            self._take(line.split(","))
        if lines:
            self._take_interventions()
        return bool(lines)

    def tell_again(self) -> None:
        """Tell everybody all from the beginning: there is another car."""
        self._beginning += 1

    def paths(self, points: int) -> list[list[list[float]]]:
        """Where the cars have been (m), thinned."""
        return [[row[1:3] for row in _thinned(rows, points)] for rows in self._rows.values()]

    def news(self, place: Place) -> Optional[dict[str, Any]]:
        """What a watcher has not been told yet, whose place moves on; None if there is nothing."""
        if not self._has_news(place):
            return None
        if begins := place.beginning != self._beginning:
            place.beginning, place.told, place.events = self._beginning, {}, 0
        count = self._forgotten + len(self._events)
        events = self._events[max(place.events - self._forgotten, 0) :]
        told = {"begins": begins, "cars": self._new_rows(place), "events": events}
        place.told = {car: rows[-1][0] for car, rows in self._rows.items()}
        place.events = count
        return told

    def _has_news(self, place: Place) -> bool:
        if place.beginning != self._beginning or place.events < self._forgotten + len(self._events):
            return bool(self._rows)
        return any(place.told.get(car) != rows[-1][0] for car, rows in self._rows.items())

    def _new_rows(self, place: Place) -> dict[str, list[list[float]]]:
        new = {car: _after(rows, place.told.get(car, -math.inf)) for car, rows in self._rows.items()}
        return {car: _thinned(rows, _MOST_ROWS) for car, rows in new.items()}

    def _new_lines(self) -> list[str]:
        """The lines completed since the last call; a file that is begun anew is another run."""
        try:
            with open(self._record, "rb") as stream:
                status = os.fstat(stream.fileno())
                if status.st_mtime < self._since:
                    return []  # of an earlier run
                if self._file not in (None, status.st_ino) or status.st_size < self._offset:
                    self._clear()
                self._file = status.st_ino
                stream.seek(self._offset)
                data = stream.read()
        except OSError:
            return []  # not there yet, or the judge says what is wrong
        self._offset += len(data)
        *lines, self._rest = (self._rest + data).split(b"\n")
        return [line.decode("utf-8", "replace") for line in lines]

    def _take(self, cells: list[str]) -> None:
        row = _shown(cells)
        if row is None:
            return
        if cells[_CAR] not in self._rows:
            self.tell_again()
        rows = self._rows.setdefault(cells[_CAR], [])
        if rows and row[0] < rows[-1][0]:  # another episode, whose file the system took for the same
            self._forget()
            rows = self._rows.setdefault(cells[_CAR], [])
        is_due = not rows or row[0] >= rows[-1][0] + _STEP - STAMP_EPSILON
        if is_due:
            rows.append(row)
            if len(rows) > _KEPT_ROWS:
                del rows[1 : _KEPT_ROWS // 2 : 2]
        names = cells[_CONTACTS]
        if names and names != self._touching.get(cells[_CAR]):
            touched = f"{cells[_CAR]} touched {' and '.join(names.split(';'))}"
            self._note({"time": row[0], "kind": "contact", "text": touched, "x": row[1], "y": row[2]})
        self._touching[cells[_CAR]] = names

    def _take_interventions(self) -> None:
        try:
            size = self._interventions.stat().st_size
            found = read_interventions(self._interventions) if size > self._noted_size else []
        except (OSError, ScenarioError):
            return  # there are none, or the judge says what is wrong
        self._noted_size = size
        for each in found[self._noted :]:
            self._note({"time": each.stamp, "kind": "intervention", "text": each.describe()})
        self._noted = max(self._noted, len(found))

    def _note(self, event: dict[str, Any]) -> None:
        self._events.append(event)
        if len(self._events) > _KEPT_EVENTS:
            del self._events[0]
            self._forgotten += 1


def _shown(cells: list[str]) -> Optional[list[Any]]:
    """What is told of a row of a record; None if it is none, which the judge will say."""
    if len(cells) != len(COLUMNS):
        return None
    try:
        row = [round(float(cells[index]), 4) if cells[index] else None for index in _SHOWN]
    except ValueError:
        return None
    return row if row[0] is not None and all(each is None or math.isfinite(each) for each in row) else None


def _after(rows: list[list[float]], time: float) -> list[list[float]]:
    """The rows after a time (s): few, at the end, of many."""
    first = len(rows)
    while first > 0 and rows[first - 1][0] > time:
        first -= 1
    return rows[first:]


def _thinned(rows: list[list[float]], most: int) -> list[list[float]]:
    """The first, the last, and every n-th between them, so that there are not more."""
    kept = rows[:: -(-len(rows) // (most - 1)) or 1]
    return kept if not rows or kept[-1] is rows[-1] else [*kept, rows[-1]]
