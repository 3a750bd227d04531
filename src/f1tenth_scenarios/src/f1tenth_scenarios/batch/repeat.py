"""The same run many times: how much do the results differ?"""

import collections
from collections.abc import Sequence
from typing import Any


def spread(results: Sequence[dict[str, Any]]) -> list[tuple[str, str]]:
    """Names and values that say how equal results are."""
    verdicts = collections.Counter(result["verdict"] for result in results)
    laps = [result["times"]["lap_time"] for result in results if result["times"]["lap_time"] is not None]
    clearances = [each["minimum_clearance"] for each in results if each["minimum_clearance"] is not None]
    hashes = len({result["trajectory_hash"] for result in results})
    return [
        ("runs", str(len(results))),
        ("verdicts", ", ".join(f"{count} {verdict}" for verdict, count in verdicts.most_common())),
        ("passed", f"{sum(result['passed'] for result in results)} of {len(results)}"),
        ("trajectories", "all the same, bit for bit" if hashes == 1 else f"{hashes} different ones"),
        ("lap time", _range(laps, "s")),
        ("minimum clearance", _range(clearances, "m")),
    ]


def is_steady(results: Sequence[dict[str, Any]], lockstep: bool) -> bool:
    """Whether every run passed with the same verdict; in lockstep with the same trajectory as well."""
    same = ["verdict", "trajectory_hash"] if lockstep else ["verdict"]
    return all(result["passed"] for result in results) and all(
        len({result[name] for result in results}) == 1 for name in same
    )


def _range(values, unit):
    if not values:
        return "none"
    least, most = min(values), max(values)
    return f"{least:.3f} {unit}" if least == most else f"{least:.3f} to {most:.3f} {unit}"
