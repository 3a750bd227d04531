"""What watchers are told of a run: read from the files that simulator and judge write."""

import dataclasses
import json
import math
import time
from collections import deque
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.files import DRAWINGS_FILE
from f1tenth_judge.record.interventions import read_interventions
from f1tenth_judge.record.record import STAMP_EPSILON
from f1tenth_judge.record.replay import Drawing
from f1tenth_judge.record.row import Row, cells_of, row_of
from f1tenth_judge.record.tail import Tail
from f1tenth_judge.report.replay_columns import pack_drawing

_STEP = 0.05  # s, between two rows of a car that are told
_MOST_ROWS = 1000  # of a car, in one message: who is farther behind gets every n-th
# Of a car, as those in live.js: then the older half loses every second one, so that a run may go on for days.
_KEPT_ROWS = 20_000
_KEPT_EVENTS = 1000  # the latest
_KEPT_DRAWN = 1 << 18  # bytes, of what was drawn latest: in memory they are ten times as much
_CLOCKS = 0.1  # s, by which the time of a file may be behind the clock, and more than enough
_SHOWN = ("time", "x", "y", "yaw", "v_x", "steering_angle", "clearance")


@dataclasses.dataclass
class Place:
    """How much of a feed a watcher has been told."""

    beginning: int = -1  # which run of the simulation it belongs to
    told: dict[str, float] = dataclasses.field(default_factory=dict)  # time of the last row (s), by car
    events: int = 0
    drawn: int = 0


class Feed:
    """Rows and events of a run, in memory once for all watchers. Not for several threads at once."""

    def __init__(self, record: Path, interventions: Path, since: Optional[float] = None):
        """`since`: when (Unix time, s) nothing of this run was written yet; none: now."""
        since = time.time() - _CLOCKS if since is None else since
        self._record, self._interventions = Tail(record, since), interventions
        self._drawings = Tail(record.with_name(DRAWINGS_FILE), since)
        self._beginning = 0
        self._noted, self._noted_size = 0, 0  # interventions, and bytes of their file
        self._forget()

    def _forget(self) -> None:
        self._beginning += 1
        self._rows: dict[str, list[list[Any]]] = {}
        self._touching: dict[str, str] = {}
        self._events: list[dict[str, Any]] = []
        self._forgotten = 0  # events
        self._drawn: deque[dict[str, Any]] = deque()
        self._sizes: deque[int] = deque()  # bytes of each
        self._drawn_before = 0

    def poll(self) -> bool:
        """Read what has been written since the last call; returns whether there was anything."""
        files = self._record.beginnings
        lines = self._record.new_lines()
        if files and self._record.beginnings != files:  # another run
            self._noted, self._noted_size = 0, 0
            self._forget()
        for line in lines:
            self._take(cells_of(line.decode("utf-8", "replace").replace("\0", "")))
        drawn = self._drawings.new_lines()
        for each in drawn:
            self._draw(each)
        if lines:
            self._take_interventions()
        return bool(lines or drawn)

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
            place.beginning, place.told, place.events, place.drawn = self._beginning, {}, 0, 0
        events = self._events[max(place.events - self._forgotten, 0) :]
        drawn = list(self._drawn)[max(place.drawn - self._drawn_before, 0) :]
        told = {"begins": begins, "cars": self._new_rows(place), "events": events, "drawn": drawn}
        place.told = {car: rows[-1][0] for car, rows in self._rows.items()}
        place.events, place.drawn = self._counts()
        return told

    def _counts(self) -> tuple[int, int]:
        """How many events and drawings there were."""
        return self._forgotten + len(self._events), self._drawn_before + len(self._drawn)

    def _has_news(self, place: Place) -> bool:
        if place.beginning != self._beginning or (place.events, place.drawn) != self._counts():
            return bool(self._rows)
        return any(place.told.get(car) != rows[-1][0] for car, rows in self._rows.items())

    def _new_rows(self, place: Place) -> dict[str, list[list[float]]]:
        new = {car: _after(rows, place.told.get(car, -math.inf)) for car, rows in self._rows.items()}
        return {car: _thinned(rows, _MOST_ROWS) for car, rows in new.items()}

    def _take(self, cells: list[str]) -> None:
        try:
            row = row_of(cells, is_partial=True)
        except ValueError:
            return  # the heads of the columns, or damaged: the judge will say so
        if row.car not in self._rows:
            self.tell_again()
        rows = self._rows.setdefault(row.car, [])
        if rows and row.time < rows[-1][0]:  # another episode, whose file the system took for the same
            self._forget()
            rows = self._rows.setdefault(row.car, [])
        if not rows or row.time >= rows[-1][0] + _STEP - STAMP_EPSILON:
            rows.append(_shown(row))
            if len(rows) > _KEPT_ROWS:
                del rows[1 : _KEPT_ROWS // 2 : 2]
        if row.contacts and row.contacts != self._touching.get(row.car):
            touched = f"{row.car} touched {' and '.join(row.contacts.split(';'))}"
            self._note({"time": row.time, "kind": "contact", "text": touched, "x": row.x, "y": row.y})
        self._touching[row.car] = row.contacts

    def _draw(self, line: bytes) -> None:
        """Keep a line of said/journal.py, and forget the oldest if there is too much."""
        try:
            told = json.loads(line)
            drawn = [pack_drawing(Drawing(**each)) for each in told["drawn"]]
            self._drawn.append({"time": float(told["time"]), "topic": str(told["topic"]), "drawn": drawn})
        except (ValueError, TypeError, KeyError):
            return  # somebody has damaged it
        self._sizes.append(len(line))
        while sum(self._sizes) > _KEPT_DRAWN and len(self._sizes) > 1:
            self._drawn.popleft()
            self._sizes.popleft()
            self._drawn_before += 1

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


def _shown(row: Row) -> list[Any]:
    """What is told of a row; None for what is not known."""
    values = (getattr(row, name) for name in _SHOWN)
    return [None if math.isnan(value) else round(value, 4) for value in values]


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
