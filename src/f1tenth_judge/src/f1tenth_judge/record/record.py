"""The simulator's record: the truth about where every car was, what it touched and how close it came."""

import dataclasses
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Optional

import numpy as np

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.files import reading
from f1tenth_judge.record.row import COLUMNS, Row, cells_of, row_of

# Stamps are written as decimals; half a nanosecond tells equal ones from neighbouring ones.
STAMP_EPSILON = 5e-10


@dataclasses.dataclass(frozen=True)
class Contact:
    """A stretch of periods in which a car touched the same things."""

    car: str
    start: float  # s
    end: float  # s
    touched: tuple[str, ...]  # names of models or cars
    x: float  # m, where the car was at the start
    y: float  # m
    speed: float  # m/s, the greatest of the touching points against each other before an impact


@dataclasses.dataclass(frozen=True)
class CarTrack:
    """What the record says of one car, one row per control period, as arrays of equal length."""

    car: str
    time: np.ndarray  # s
    x: np.ndarray  # m
    y: np.ndarray  # m
    yaw: np.ndarray  # rad
    v_x: np.ndarray  # m/s, along the car
    v_y: np.ndarray  # m/s, to the left of the car
    yaw_rate: np.ndarray  # rad/s
    steering_angle: np.ndarray  # rad
    clearance: np.ndarray  # m
    contacts: tuple[str, ...]  # names joined by ";", empty without contact
    contact_speed: np.ndarray  # m/s, see Contact
    hash: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]  # as they are in the file

    def until(self, stamp: float) -> "CarTrack":
        """The periods up to and including a stamp (s)."""
        count = int(np.searchsorted(self.time, stamp + STAMP_EPSILON))
        return CarTrack(
            self.car, *(getattr(self, field.name)[:count] for field in dataclasses.fields(self)[1:])
        )

    def places(self) -> Iterator[tuple[float, float, float, float]]:
        """Stamp (s), x, y (m) and yaw (rad) of each period."""
        return zip(self.time.tolist(), self.x.tolist(), self.y.tolist(), self.yaw.tolist())

    @property
    def speed(self) -> np.ndarray:
        """Magnitude of the velocity, m/s."""
        return np.hypot(self.v_x, self.v_y)

    def contact_list(self) -> list[Contact]:
        """Contacts in order; neighbouring periods that touch the same things are one."""
        found: list[Contact] = []
        for index, names in enumerate(self.contacts):
            if not names:
                continue
            if index and self.contacts[index - 1] == names:
                speed = max(found[-1].speed, float(self.contact_speed[index]))
                found[-1] = dataclasses.replace(found[-1], end=float(self.time[index]), speed=speed)
            else:
                found.append(self._contact(index, names))
        return found

    def _contact(self, index: int, names: str) -> Contact:
        stamp, x, y = (float(values[index]) for values in (self.time, self.x, self.y))
        return Contact(
            self.car, stamp, stamp, tuple(names.split(";")), x, y, float(self.contact_speed[index])
        )


@dataclasses.dataclass(frozen=True)
class Record:
    """All cars of a run."""

    tracks: dict[str, CarTrack]

    @property
    def end(self) -> Optional[float]:
        """Stamp of the last period (s); nothing when there is none."""
        ends = [float(track.time[-1]) for track in self.tracks.values() if len(track.time)]
        return max(ends) if ends else None

    def until(self, stamp: float) -> "Record":
        """The periods up to and including a stamp (s)."""
        return Record({name: track.until(stamp) for name, track in self.tracks.items()})

    def covering(self, stamp: float) -> "Record":
        """The periods up to the first that is not before a stamp (s)."""
        ends = [
            float(track.time[index])
            for track in self.tracks.values()
            if (index := int(np.searchsorted(track.time, stamp - STAMP_EPSILON))) < len(track.time)
        ]
        return self.until(max(ends)) if ends else self

    def hash_at_end(self) -> Optional[str]:
        """The trajectory hash of the last period; nothing when there is none."""
        last = [(float(track.time[-1]), track.hash[-1]) for track in self.tracks.values() if len(track.time)]
        return max(last)[1] if last else None


def first_record(path: Path) -> Path:
    """The file of what was recorded until the first reset of the simulation, which keeps that apart."""
    kept = path.with_name(f"{path.name}.before_reset_1")
    return kept if kept.exists() else path


def read_record(path: Path) -> Record:
    """Read the file that the simulator wrote; a last line that it could not finish is left out.

    Raises:
        ScenarioError: the file is not a record.
    """
    try:
        with reading(path) as stream:
            text = stream.read().decode()
    except FileNotFoundError:
        return Record({})
    except OSError as error:
        raise ScenarioError(f"{path}: cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise ScenarioError(f"{path}: not a record of the simulator: {error}") from error
    complete = text[: text.rfind("\n") + 1].splitlines()
    if not complete:
        return Record({})
    if tuple(complete[0].split(",")) != COLUMNS:
        raise ScenarioError(
            f"{path}:1: not a record of the simulator: the columns must be {','.join(COLUMNS)}"
        )
    return _build(path, complete[1:])


def _build(path: Path, lines: Sequence[str]) -> Record:
    by_car: dict[str, list[tuple[Row, tuple[str, ...]]]] = {}
    for number, line in enumerate(lines, start=2):
        cells = cells_of(line)
        try:
            row = row_of(cells)
        except ValueError as error:
            raise ScenarioError(f"{path}:{number}: {error}") from error
        by_car.setdefault(row.car, []).append((row, tuple(cells)))
    return Record({car: _track(car, *zip(*each)) for car, each in by_car.items()})


def _track(car: str, rows: Sequence[Row], cells: tuple[tuple[str, ...], ...]) -> CarTrack:
    columns: dict[str, Any] = dict(zip(COLUMNS, zip(*rows)))
    words = {name: columns[name] for name in ("contacts", "hash")}
    numbers: dict[str, Any] = {name: np.array(columns[name]) for name in columns.keys() - {"car", *words}}
    return CarTrack(car=car, rows=cells, **words, **numbers)
