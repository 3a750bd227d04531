"""Scenarios and records made up for tests."""

import csv

from f1tenth_judge.places.packages import package_path
from f1tenth_judge.places.place import Place
from f1tenth_judge.plan.car_plan import CarPlan
from f1tenth_judge.plan.driver_file import read_driver_file
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.task import Task
from f1tenth_judge.record.observations import Failure, Observations, RaceState, RaceUpdate
from f1tenth_judge.record.record import read_record
from f1tenth_judge.record.row import COLUMNS
from f1tenth_judge.scenario.car import Car, Pose
from f1tenth_judge.scenario.criteria import Criteria
from f1tenth_judge.scenario.scenario import Limits, Scenario, Verdict

PERIOD = 0.025
GOALS = {"robot1": (Pose(1.0, 0.0), Pose(2.0, 0.0), Pose(3.0, 0.0))}
DRIVERS = package_path("f1tenth_scenarios") / "launch" / "drivers"

SCENARIO_TEXT = """\
description: A car drives a metre.
world: circuit1
cars:
  - name: robot1
    goals: circuit1
limits:
  timeout: 10.0
expected: success
seed: 1
"""


def scenario(expected=Verdict.SUCCESS, timeout=10.0, cars=("robot1",), **others):
    if expected is Verdict.ERROR:
        others.setdefault("culprit", "robot1/move_base")
    return Scenario(
        description="a test",
        world="circuit1",
        cars=tuple(Car(name, goals="circuit1") for name in cars),
        limits=Limits(timeout=timeout),
        expected=expected,
        seed=1,
        time_to_start=others.pop("time_to_start", 0),
        **others,
    )


def tasks(goals=None, laps=1):
    """What race_mgr has to do with some goals per car."""
    return {
        car: Task(poses * laps, obeys_start=True, reports=True) for car, poses in (goals or GOALS).items()
    }


TASKS = tasks()


def sample_plan(folder, wanted, results=None, launch="move_base.launch"):
    """A run of a scenario whose cars have the same driver, on files that need not be there."""
    goals = {car.name: GOALS["robot1"] for car in wanted.cars}
    driver = read_driver_file(DRIVERS / launch)
    return Plan(
        name="sample",
        file=folder / "sample.yaml",
        scenario=wanted,
        place=Place(folder / "w.world", folder / "w.yaml", None, None),
        cars={
            car: CarPlan(Pose(0.0, 0.0), driver, folder / "goals.txt", goals[car], None, task)
            for car, task in tasks(goals, wanted.laps).items()
        },
        folder=results or folder,
    )


def with_clearance(limit, **others):
    return scenario(criteria=Criteria(minimum_clearance=limit), **others)


def rows(end, car="robot1", speed=1.0, contacts=None, clearance=0.5, y=0.0, contact_speed=None):
    """A car on the x axis, one row per period up to `end` (s); contacts: {stamp: names}, with its speed."""
    contacts = contacts or {}
    for index in range(1, round(end / PERIOD) + 1):
        time = index * PERIOD
        names = next((value for stamp, value in contacts.items() if abs(stamp - time) < 1e-6), "")
        impact = (speed if contact_speed is None else contact_speed) if names else 0
        yield [
            f"{time:.9f}", car, speed * time, y, 0, speed, 0, 0, 0, clearance, names, impact, f"hash{index}",
        ]  # fmt: skip


def write_record(path, *cars):
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(COLUMNS)
        for car_rows in cars:
            writer.writerows(car_rows)
    return path


def record(folder, *cars):
    return read_record(write_record(folder / "record.csv", *cars))


def racing(stamp=0.0, car="robot1"):
    return RaceUpdate(car, stamp, RaceState.RACING, 0)


def reached(stamp, count, car="robot1"):
    return RaceUpdate(car, stamp, RaceState.RACING, count)


def finished(stamp, car="robot1", count=3):
    return RaceUpdate(car, stamp, RaceState.FINISHED, count)


def aborted(stamp, car="robot1", reason="goal 2 of 3 aborted: Failed to find a valid plan."):
    return RaceUpdate(car, stamp, RaceState.ABORTED, 1, reason)


def seen(run_record, *updates, failure=None):
    return Observations(run_record, updates, failure)


def died(culprit="robot1/move_base"):
    return Failure(culprit, "was killed by signal 9", "/log/move_base.log", ("last words",))
