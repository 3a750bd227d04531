"""What planners say besides their commands, kept within limits for the replay."""

import dataclasses
import math
from collections.abc import Sequence
from typing import Any, Callable, Optional

from f1tenth_judge.record.record import STAMP_EPSILON
from f1tenth_judge.record.replay import Drawing, Numbers, Replay, Timed

_DRAWING_PERIOD, _NUMBER_PERIOD, _PICTURE_PERIOD = 0.2, 0.025, 0.5  # s, between two that are kept
_BURST = 0.05  # s, in which single markers make one drawing
_MOST_POINTS = 100_000  # of what a topic draws
_MOST_TOPICS = 20  # that draw, and that have numbers
_MOST_PICTURES, _MOST_CAMERAS = 300, 4  # of a camera, 1.5 MB; of all cars


@dataclasses.dataclass
class _Kept:
    stamps: list[float] = dataclasses.field(default_factory=list)
    values: list[Any] = dataclasses.field(default_factory=list)
    car: str = ""
    points: int = 0
    is_full: bool = False

    def is_due(self, now: float, period: float) -> bool:
        return not self.stamps or now + STAMP_EPSILON >= self.stamps[-1] + period

    def add(self, now: float, value: Any) -> None:
        self.stamps.append(round(now, 9))
        self.values.append(value)


class Said:
    """By topic. Each function returns whether more of the topic is wanted."""

    def __init__(self, on_drawing: Callable[[str, float, Sequence[Drawing]], None] = lambda *_: None):
        """Nothing was said yet. `on_drawing` is told each topic, time (s) and drawing that is kept."""
        self._on_drawing = on_drawing
        self._drawings: dict[str, _Kept] = {}
        self._numbers: dict[str, _Kept] = {}
        self._pictures: dict[str, _Kept] = {}
        self._refused: set[str] = set()
        self.left_out: list[str] = []  # topics that are too much, in words

    def draw(self, topic: str, now: float, shown: Callable[[float], Sequence[Drawing]]) -> bool:
        """Something is drawn anew at a time (s): what `shown` gives at that time."""
        kept = self._kept(self._drawings, topic, _MOST_TOPICS, "of its kind")
        if kept is None:
            return False
        if kept.stamps and now < kept.stamps[-1] + _BURST:
            kept.values[-1] = shown(now)
        elif kept.is_due(now, _DRAWING_PERIOD):
            kept.points += _size(kept.values[-1]) if kept.values else 0
            if kept.points > _MOST_POINTS:
                return self._fill(
                    kept, f"{topic}: left out from {now:.3f} s on, as it has more than {_MOST_POINTS} points"
                )
            kept.add(now, shown(now))
        else:
            return True
        self._on_drawing(topic, kept.stamps[-1], kept.values[-1])
        return True

    def number(self, topic: str, now: float, value: float, car: str) -> bool:
        """A car's planner has published a number at a time (s)."""
        kept = self._kept(self._numbers, topic, _MOST_TOPICS, "of its kind")
        if kept is None:
            return False
        if kept.is_due(now, _NUMBER_PERIOD) and math.isfinite(value):
            kept.car = car
            kept.add(now, value)
        return True

    def picture(self, topic: str, now: float, small: Callable[[], Optional[str]]) -> bool:
        """A camera was looked at at a time (s); `small`: of thumbnails, nothing if that is no picture."""
        kept = self._kept(self._pictures, topic, _MOST_CAMERAS, "cameras")
        if kept is None:
            return False
        if kept.is_due(now, _PICTURE_PERIOD) and (made := small()):
            if len(kept.values) == _MOST_PICTURES:
                return self._fill(
                    kept,
                    f"{topic}: left out from {now:.3f} s on, as there are over {_MOST_PICTURES} pictures",
                )
            kept.add(now, made)
        return True

    def replay(self) -> Replay:
        """All of it."""
        return Replay(
            drawings={
                topic: Timed(each.stamps, each.values)
                for topic, each in self._drawings.items()
                if any(each.values)
            },
            channels={
                topic: Numbers(each.stamps, each.values, each.car)
                for topic, each in self._numbers.items()
                if each.values
            },
            pictures={
                topic: Timed(each.stamps, each.values)
                for topic, each in self._pictures.items()
                if each.values
            },
        )

    def _kept(self, kind: dict[str, _Kept], topic: str, most: int, what: str) -> Optional[_Kept]:
        if topic not in kind and len(kind) < most:
            kind[topic] = _Kept()
        if topic in kind:
            return None if kind[topic].is_full else kind[topic]
        if topic not in self._refused:
            self._refused.add(topic)
            self.left_out.append(f"{topic}: left out, as there are more than {most} {what}")
        return None

    def _fill(self, kept: _Kept, why: str) -> bool:
        kept.is_full = True
        self.left_out.append(why)
        return False


def _size(drawn: Sequence[Drawing]) -> int:
    return sum(sum(map(len, each.lines)) + len(each.dots) + len(each.texts) for each in drawn)
