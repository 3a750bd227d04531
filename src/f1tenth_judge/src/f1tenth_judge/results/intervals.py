"""Confidence intervals (95 %) of rates and means, and of how much two of them differ."""

import dataclasses
import math
import statistics
from collections.abc import Mapping, Sequence
from typing import NamedTuple, Optional

from scipy.stats import binomtest, t

_CONFIDENCE = 0.95


class Interval(NamedTuple):
    """An estimate, and between which values the truth is."""

    value: float
    low: float
    high: float


@dataclasses.dataclass(frozen=True)
class Rate:
    """How many of how many."""

    passed: int
    count: int

    @property
    def interval(self) -> Interval:
        """The rate, with Wilson's interval."""
        low, high = binomtest(self.passed, self.count).proportion_ci(_CONFIDENCE, method="wilson")
        return Interval(self.passed / self.count, low, high)

    def __str__(self) -> str:
        value, low, high = self.interval
        return f"{self.passed} of {self.count} ({value:.0%}; 95 % interval {low:.0%} to {high:.0%})"


def change_of_rate(before: Rate, after: Rate) -> Interval:
    """By how much a rate has become greater (Newcombe's interval, of the two of Wilson)."""
    (old, old_low, old_high), (new, new_low, new_high) = before.interval, after.interval
    change = new - old
    low, high = math.hypot(new - new_low, old_high - old), math.hypot(new_high - new, old - old_low)
    return Interval(change, change - low, change + high)


def mean_of(values: Sequence[float]) -> Interval:
    """The mean, with Student's interval; no width for one value."""
    count = len(values)
    variance = statistics.variance(values) / count if count > 1 else 0.0
    return _around(statistics.fmean(values), variance, max(count - 1, 1))


def change_of_mean(before: Mapping[int, float], after: Mapping[int, float]) -> Optional[Interval]:
    """By how much a mean has become greater; nothing where there are fewer than two values on a side.

    Values by seed: those of the same seeds are compared in pairs, others as independent samples (Welch).
    """
    pairs = [after[seed] - before[seed] for seed in sorted(before.keys() & after.keys())]
    if len(pairs) > 1:
        return mean_of(pairs)
    sides = [list(each.values()) for each in (before, after)]
    if min(map(len, sides)) < 2:
        return None
    change = statistics.fmean(sides[1]) - statistics.fmean(sides[0])
    parts = [statistics.variance(each) / len(each) for each in sides]
    shares = sum(part**2 / (len(each) - 1) for part, each in zip(parts, sides))
    return _around(change, sum(parts), sum(parts) ** 2 / shares if shares else 1.0)


def _around(value: float, variance: float, freedom: float) -> Interval:
    half = float(t.ppf((1.0 + _CONFIDENCE) / 2.0, freedom)) * math.sqrt(variance)
    return Interval(value, value - half, value + half)
