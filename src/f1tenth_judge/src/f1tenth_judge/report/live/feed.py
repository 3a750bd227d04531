"""What watchers are told: read from the files that the simulator writes."""

import dataclasses
import math
import os
import threading
import time
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.interventions import read_interventions
from f1tenth_judge.record.record import COLUMNS, STAMP_EPSILON

_STEP = 0.05  # s, between two rows of a car that are told
_MOST_ROWS = 1000  # of a car, in one message: who is farther behind gets every n-th
_KEPT = [COLUMNS.index(name) for name in ("time", "x", "y", "yaw", "v_x", "steering_angle", "clearance")]
_CAR, _CONTACTS = COLUMNS.index("car"), COLUMNS.index("contacts")


@dataclasses.dataclass
class Place:
    """How much of the feed a watcher has been told."""

    beginning: int = -1  # which run of the simulation it belongs to
    rows: dict[str, int] = dataclasses.field(default_factory=dict)  # by car
    events: int = 0


class Feed:
    """Rows and events of a run, in memory once for all watchers; any thread may ask for news."""

    def __init__(self, record: Path, interventions: Path):
        self._record, self._interventions = record, interventions
        self._since = time.time()
        self._changed = threading.Condition()
        self._beginning = 0
        self._clear()
        self.end: Optional[dict[str, Any]] = None

    def _clear(self) -> None:
        self._file: Optional[int] = None  # inode
        self._offset, self._rest = 0, b""
        self._rows: dict[str, list[list[float]]] = {}
        self._touching: dict[str, str] = {}
        self._events: list[dict[str, Any]] = []
        self._noted = 0  # interventions

    def poll(self) -> None:
        """Read what has been written since the last call."""
        with self._changed:
            for line in self._new_lines():
                self._take(line.split(","))
            self._take_interventions()
            self._changed.notify_all()

    def finish(self, end: dict[str, Any]) -> None:
        """The run is over."""
        with self._changed:
            self.end = end
            self._changed.notify_all()

    def news(self, place: Place, patience: float) -> Optional[dict[str, Any]]:
        """What a watcher has not been told yet, whose place moves on; None if nothing comes in time (s)."""
        with self._changed:
            self._changed.wait_for(lambda: self._has_news(place) or self.end is not None, patience)
            if not self._has_news(place):
                return None
            if begins := place.beginning != self._beginning:
                place.beginning, place.rows, place.events = self._beginning, {}, 0
            told = {"begins": begins, "cars": self._new_rows(place), "events": self._events[place.events :]}
            place.rows = {car: len(rows) for car, rows in self._rows.items()}
            place.events = len(self._events)
            return told

    def _has_news(self, place: Place) -> bool:
        if place.beginning != self._beginning or place.events < len(self._events):
            return bool(self._rows)
        return any(place.rows.get(car, 0) < len(rows) for car, rows in self._rows.items())

    def _new_rows(self, place: Place) -> dict[str, list[list[float]]]:
        new = {car: rows[place.rows.get(car, 0) :] for car, rows in self._rows.items()}
        return {car: rows[:: -(-len(rows) // _MOST_ROWS) or 1] for car, rows in new.items()}

    def _new_lines(self) -> list[str]:
        """The lines completed since the last call; a file that is begun anew is another run."""
        try:
            with open(self._record, "rb") as stream:
                status = os.fstat(stream.fileno())
                if status.st_mtime < self._since:
                    return []  # of an earlier run
                if self._file not in (None, status.st_ino) or status.st_size < self._offset:
                    self._clear()
                    self._beginning += 1
                self._file = status.st_ino
                stream.seek(self._offset)
                data = stream.read()
        except FileNotFoundError:
            return []
        self._offset += len(data)
        *lines, self._rest = (self._rest + data).split(b"\n")
        return [line.decode("utf-8", "replace") for line in lines]

    def _take(self, cells: list[str]) -> None:
        if len(cells) != len(COLUMNS) or cells[0] == COLUMNS[0]:
            return
        row = [round(float(cells[index]), 4) for index in _KEPT]
        rows = self._rows.setdefault(cells[_CAR], [])
        if all(map(math.isfinite, row)) and (not rows or row[0] >= rows[-1][0] + _STEP - STAMP_EPSILON):
            rows.append(row)
        names = cells[_CONTACTS]
        if names and names != self._touching.get(cells[_CAR]):
            touched = f"{cells[_CAR]} touched {' and '.join(names.split(';'))}"
            self._events.append(
                {"time": row[0], "kind": "contact", "text": touched, "x": row[1], "y": row[2]}
            )
        self._touching[cells[_CAR]] = names

    def _take_interventions(self) -> None:
        try:
            found = read_interventions(self._interventions)
        except ScenarioError:
            return  # the judge says so
        for each in found[self._noted :]:
            self._events.append({"time": each.stamp, "kind": "intervention", "text": each.describe()})
        self._noted = len(found)
