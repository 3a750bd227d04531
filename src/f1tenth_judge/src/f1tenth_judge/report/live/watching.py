"""The run's side: starts the process that serves the watchers, and tells it how the run ended."""

import contextlib
import json
import subprocess
import sys
from collections.abc import Iterator
from typing import Any, Callable

from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.results.standing import who


@contextlib.contextmanager
def watched(plan: Plan) -> Iterator[Callable[[str], None]]:
    """Serve a run on this machine while the block lasts, and print the address.

    Nothing that watchers do reaches the run: the other process only reads what is recorded, at low priority.
    The block is given a function that sends the watchers to a page below the folder of all results.
    """
    command = [sys.executable, "-m", "f1tenth_judge.report.live"]
    process = subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0, start_new_session=True
    )
    assert process.stdin is not None
    assert process.stdout is not None
    with process.stdin as order, process.stdout as answer:
        _say(order, task_of(plan))
        address = answer.readline().decode().strip()
        print(f"{'watch:':19}{address or 'cannot be served'}", flush=True)
        yield lambda page: _say(order, {"page": page})


def task_of(plan: Plan) -> dict[str, Any]:
    """What the other process needs to know."""
    own = {name: car.description for name, car in plan.cars.items()}
    course = plan.course
    return {
        "name": plan.name,
        "description": plan.scenario.description,
        "cars": {car.name: who(car) for car in plan.scenario.cars},
        "descriptions": {name: each and (each.text, str(each.file)) for name, each in own.items()},
        "world": str(plan.run_world),
        "goals": {car: [(pose.x, pose.y, pose.yaw) for pose in poses] for car, poses in plan.goals.items()},
        "road": [] if course is None else list(zip(course.x, course.y)),
        "record": str(plan.record_file),
        "interventions": str(plan.interventions_file),
        "results": str(plan.folder.parent),
    }


def _say(order, content: dict[str, Any]) -> None:
    with contextlib.suppress(BrokenPipeError):  # it has ended: nobody can watch
        order.write(json.dumps(content).encode() + b"\n")
