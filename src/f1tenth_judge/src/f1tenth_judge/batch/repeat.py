"""The same run many times: how much do the results differ? `f1tenth run --repeat`."""

import collections
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from f1tenth_judge.batch.jobs import Job, run_jobs
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.results.console import CountLine
from f1tenth_judge.stop_request import StopRequest

_WHY = ": does the planner ask the wall clock, or draw random numbers without a seed?"


def repeat(
    name: str,
    count: int,
    results: Path,
    settings: Sequence[str],
    stop: StopRequest,
    at_once: int = 1,
    bag: bool = False,
) -> bool:
    """Run a scenario `count` times and print how much the results differ.

    Returns:
        Whether all passed with the same verdict, and in lockstep with the same trajectory.

    Raises:
        ScenarioError: bad input, or a run left no result.
    """
    plan = make_plan(name, settings=settings)
    folder = results / "repeat" / plan.name
    options = ("--bag",) if bag else ()
    jobs = [
        Job(str(plan.file), tuple(settings), str(folder / f"{number:03}"), options)
        for number in range(1, count + 1)
    ]
    bar = CountLine(f"{plan.name} repeated", count)
    found: list[dict[str, Any]] = []
    problems: list[str] = []

    for outcome in run_jobs(jobs, stop, at_once):
        if outcome.result is None:
            problems.append(outcome.problem)
        else:
            found.append(outcome.result)
        bar.update(outcome.exit_code == 0)
    bar.clear()
    if problems and not stop.signal:
        raise ScenarioError("\n".join(problems))
    for key, value in [("scenario", plan.name), *spread(found)]:
        print(f"{key + ':':19}{value}")
    return is_steady(found)


def spread(results: Sequence[dict[str, Any]]) -> list[tuple[str, str]]:
    """Names and values that say how equal results are."""
    verdicts = collections.Counter(result["verdict"] for result in results)
    laps = [result["times"]["lap_time"] for result in results if result["times"]["lap_time"] is not None]
    clearances = [each["minimum_clearance"] for each in results if each["minimum_clearance"] is not None]
    return [
        ("runs", str(len(results))),
        ("verdicts", ", ".join(f"{count} {verdict}" for verdict, count in verdicts.most_common()) or "none"),
        ("passed", f"{sum(result['passed'] for result in results)} of {len(results)}"),
        ("trajectories", _trajectories(results)),
        *[("note", note) for note in dict.fromkeys(result.get("note") for result in results) if note],
        ("lap time", _range(laps, "s")),
        ("minimum clearance", _range(clearances, "m")),
    ]


def _trajectories(results):
    hashes = len({result["trajectory_hash"] for result in results})
    if not results:
        return "none"
    if hashes == 1:
        return "all the same, bit for bit"
    why = _WHY if _in_lockstep(results) else ""
    return f"{hashes} different ones{why}"


def _in_lockstep(results):
    return all(each.get("lockstep", True) for each in results)


def is_steady(results: Sequence[dict[str, Any]]) -> bool:
    """Whether every run passed with the same verdict; in lockstep with the same trajectory as well."""
    return all(result["passed"] for result in results) and not difference(results)


def difference(results: Sequence[dict[str, Any]]) -> str:
    """How runs of the same inputs differ though they should not; empty if they do not."""
    if _in_lockstep(results) and len({result["trajectory_hash"] for result in results}) > 1:
        return f"trajectories: {_trajectories(results)}"
    verdicts = {result["verdict"] for result in results}
    return f"verdicts: {', '.join(sorted(verdicts))}" if len(verdicts) > 1 else ""


def _range(values, unit):
    if not values:
        return "none"
    least, most = min(values), max(values)
    return f"{least:.3f} {unit}" if least == most else f"{least:.3f} to {most:.3f} {unit}"
