"""Noticing a driver without proper commands: silence, nonsense, or a flood, by the simulator's counts."""

import dataclasses
from collections.abc import Iterable
from typing import NamedTuple, Optional

_MOST_PER_SECOND = 400.0  # of simulated time; a lidar scans 40 times
_NONSENSE_SAMPLES = 2  # in a row with nothing but refused commands


@dataclasses.dataclass(frozen=True)
class CommandCount:
    """What the simulator has counted of a car's commands so far."""

    stamp: float  # s, simulated
    car: str
    accepted: int
    refused: int
    refusal: str = ""  # why the last one was refused


class Problem(NamedTuple):
    """What is wrong with the commands of a car's driver."""

    car: str
    text: str
    stamp: float  # s, simulated, when it was clear
    is_mute: bool = False  # whether there has been no command at all


class CommandWatch:
    """Follows the counts of some cars, each with a steady rate."""

    def __init__(self, cars: Iterable[str], silence: float, load: float = 0.0):
        """Simulated times (s) without any command that a driver may let pass; `load`: if more, at first."""
        self._silence = silence
        self._load = load
        self._last: dict[str, Optional[CommandCount]] = dict.fromkeys(cars)
        self._heard: dict[str, float] = dict.fromkeys(self._last, 0.0)
        self._nonsense: dict[str, int] = dict.fromkeys(self._last, 0)
        self._problems: dict[str, Problem] = {}

    def take(self, count: CommandCount) -> None:
        """Take the next count of a car; those of other cars are ignored."""
        if count.car not in self._last:
            return
        before = self._last[count.car] or CommandCount(0.0, count.car, 0, 0)
        self._last[count.car] = count
        accepted, refused = count.accepted - before.accepted, count.refused - before.refused
        if accepted or refused:
            self._heard[count.car] = count.stamp
        self._nonsense[count.car] = self._nonsense[count.car] + 1 if refused and not accepted else 0
        problem = self._problem(count, (accepted + refused) / max(count.stamp - before.stamp, 1e-9))
        if problem:
            is_mute = not self._heard[count.car]
            self._problems.setdefault(count.car, Problem(count.car, problem, count.stamp, is_mute))

    def problems(self, done: set[str]) -> list[Problem]:
        """Those of cars that are not done."""
        return [each for each in self._problems.values() if each.car not in done]

    def _problem(self, count: CommandCount, rate: float) -> str:
        if rate > _MOST_PER_SECOND:
            often = f"{rate:.0f} commands per second of simulated time (at {count.stamp:g} s)"
            return f"sends {often}, may be {_MOST_PER_SECOND:.0f}"
        if self._nonsense[count.car] >= _NONSENSE_SAMPLES:
            return f"sends only commands that the simulator refuses (at {count.stamp:g} s): {count.refusal}"
        last = self._heard[count.car]
        quiet = count.stamp - last
        loads = not last and self._load > self._silence
        if quiet < (self._load if loads else self._silence):
            return ""
        never, since = (" at all", "") if not last else ("", f", none since {last:g} s")
        limit = "load" if loads else "silence"
        return f"has sent no command{never} for {quiet:g} s of simulated time (limits.{limit}){since}"
