"""Runs of a scenario with several seeds beside others: has it become worse, beyond chance?"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Callable, Optional

from f1tenth_judge.results.intervals import Interval, Rate, change_of_mean, change_of_rate

Results = Sequence[Mapping[str, Any]]


def cells_of_seeds(before: Results, after: Results) -> tuple[str, str, str]:
    """What is told of verdicts, best laps and clearances."""
    rates = [str(_passed(each)) if each else "not run" for each in (before, after)]
    return " -> ".join(rates), _means(before, after, _lap, "s"), _means(before, after, _clearance, "m")


def problems_of_seeds(
    before: Results, after: Results, lap_time: Optional[float], clearance: Optional[float]
) -> Iterator[str]:
    """What has become worse: where the whole interval of a change is on the wrong side of what is allowed.

    Args:
        before, after: results of runs that differ in their seeds
        lap_time: how much slower best laps may be on average, as a part of those before
        clearance: how much less the minimum clearance may be on average, m
    """
    change = change_of_rate(_passed(before), _passed(after))
    if change.high < 0.0:
        yield f"passed {_passed(after)} instead of {_passed(before)}"
    laps = change_of_mean(_by_seed(before, _lap), _by_seed(after, _lap))
    if laps and lap_time is not None:
        allowed = lap_time * _mean(before, _lap)
        if laps.low > allowed:
            yield f"lap time {_told(laps, 's')}, may be {allowed:+.3f} s"
    room = change_of_mean(_by_seed(before, _clearance), _by_seed(after, _clearance))
    if room and clearance is not None and room.high < -clearance:
        yield f"clearance {_told(room, 'm')}, may be {-clearance:+.3f} m"


def _passed(results: Results) -> Rate:
    return Rate(sum(each["passed"] for each in results), len(results))


def _lap(result):
    return result["times"]["lap_time"]


def _clearance(result):
    return result["minimum_clearance"]


def _by_seed(results: Results, measure: Callable) -> dict[int, float]:
    return {each["seed"]: measure(each) for each in results if measure(each) is not None}


def _mean(results: Results, measure: Callable) -> float:
    values = _by_seed(results, measure).values()
    return sum(values) / len(values)


def _means(before: Results, after: Results, measure: Callable, unit: str) -> str:
    sides = [_by_seed(each, measure) for each in (before, after)]
    change = change_of_mean(*sides)
    texts = [f"{sum(each.values()) / len(each):.3f} {unit}" if each else "none" for each in sides]
    return " -> ".join(texts) + (f" ({_told(change, unit)})" if change else "")


def _told(change: Interval, unit: str) -> str:
    return f"{change.value:+.3f} {unit}, 95 % interval {change.low:+.3f} to {change.high:+.3f} {unit}"
