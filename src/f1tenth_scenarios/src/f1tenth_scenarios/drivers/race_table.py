"""Who leads a race: laps counted at the line, for any number of cars."""

import dataclasses
from collections.abc import Sequence

from f1tenth_scenarios.judge.start_line import LapCounter
from f1tenth_scenarios.scenario.scenario import StartLine


@dataclasses.dataclass(frozen=True)
class Standing:
    """How a car stands."""

    car: str
    lap_times: tuple[float, ...]  # s
    finish: float  # s, when the line was crossed last; 0 before the first time
    finished: bool
    contacts: int


class RaceTable:
    """Follows the cars of a race."""

    def __init__(self, line: StartLine, cars: Sequence[str], laps: int):
        self.laps = laps
        self._line = line
        self._counters: dict[str, LapCounter] = {}
        self._contacts = dict.fromkeys(cars, 0)

    def take_place(self, car: str, time: float, x: float, y: float) -> bool:
        """Take where a car is (s, m); whether it has just completed a lap. The first begins its race."""
        counter = self._counters.setdefault(car, LapCounter(self._line, time))
        return not self._is_finished(car) and counter.update(time, x, y)

    def take_contacts(self, car: str, count: int) -> None:
        """Take how often a car has touched something so far."""
        self._contacts[car] = count

    def standings(self) -> list[Standing]:
        """The cars, the leader first."""
        found = [self._standing(car) for car in self._contacts]
        return sorted(found, key=lambda each: (-len(each.lap_times), each.finish, each.car))

    @property
    def is_over(self) -> bool:
        """Whether every car has completed all laps."""
        return all(self._is_finished(car) for car in self._contacts)

    def text(self) -> str:
        """The standings as a table."""
        rows = [("", "car", "laps", "best lap", "total", "contacts")]
        for place, each in enumerate(self.standings(), start=1):
            best = f"{min(each.lap_times):.3f} s" if each.lap_times else "none"
            total = f"{sum(each.lap_times):.3f} s"
            rows.append((f"{place}.", each.car, str(len(each.lap_times)), best, total, str(each.contacts)))
        widths = [max(map(len, column)) for column in zip(*rows)]
        return "\n".join(
            "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows
        )

    def _is_finished(self, car: str) -> bool:
        return car in self._counters and len(self._counters[car].lap_times) >= self.laps

    def _standing(self, car: str) -> Standing:
        counter = self._counters.get(car)
        times, finish = (tuple(counter.lap_times), counter.finish or 0.0) if counter else ((), 0.0)
        return Standing(car, times, finish, self._is_finished(car), self._contacts[car])
