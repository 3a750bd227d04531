"""What a run needs to know about one of its cars."""

import dataclasses
from pathlib import Path
from typing import Optional

from f1tenth_scenarios import places
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.plan.driver_plan import DriverPlan, plan_driver
from f1tenth_scenarios.plan.task import Task
from f1tenth_scenarios.road.course import Course, read_course
from f1tenth_scenarios.road.goals import goals_along, read_goals
from f1tenth_scenarios.road.place import Place, line_across
from f1tenth_scenarios.road.raceline import read_raceline
from f1tenth_scenarios.scenario.car import Car, Pose
from f1tenth_scenarios.scenario.scenario import Scenario, StartLine


@dataclasses.dataclass(frozen=True)
class CarPlan:
    """A car with everything that its driver and its judge must know."""

    start: Pose
    driver: DriverPlan
    goals_file: Optional[Path]  # nothing when it has no goals, or they are in no file
    goals: tuple[Pose, ...]  # of one lap
    line: Optional[Path]  # that it may follow
    task: Task


@dataclasses.dataclass(frozen=True)
class Surroundings:
    """Where all cars of a scenario drive."""

    scenario: Scenario
    place: Place
    beside: Path  # folder from which paths count


def plan_car(car: Car, around: Surroundings) -> CarPlan:
    """Find and read what a scenario says about a car.

    Raises:
        ScenarioError: what is wrong.
    """
    driver = plan_driver(car, around.beside)
    goals_file, goals = _goals(car, driver, around)
    return CarPlan(
        start=car.start or _start(car, around.place),
        driver=driver,
        goals_file=goals_file,
        goals=goals,
        line=_line(car, driver, around),
        task=_task(car, goals, around),
    )


def _start(car: Car, place: Place) -> Pose:
    return place.ahead_of_start(car.ahead) if car.ahead else place.start()


def _goals(car: Car, driver: DriverPlan, around: Surroundings) -> tuple[Optional[Path], tuple[Pose, ...]]:
    """The goals file, and what is in it; for a driver that cannot do without, those of the road."""
    place = around.place
    if car.goals:
        path = places.goals_file(car.goals, around.beside)
    elif not driver.needs("goals_file") or place.road is None:
        return None, ()
    elif place.is_circuit:
        path = places.goals_file(place.world.stem, around.beside)
    else:
        return None, goals_along(read_course(place.road))
    return path, tuple(read_goals(path))


def _task(car: Car, goals: tuple[Pose, ...], around: Surroundings) -> Task:
    if not car.laps:
        return Task(goals * around.scenario.laps)
    return Task((), car.laps, _start_line(around))


def _start_line(around: Surroundings) -> StartLine:
    if around.scenario.start_line:
        return around.scenario.start_line
    course = _course(around)
    if course is None:
        raise ScenarioError(
            f"'laps' of a car needs a 'start_line' or a 'course': {around.place.world} is no circuit and has"
            " no centreline beside it"
        )
    return line_across(course, around.place.start())


def _course(around: Surroundings) -> Optional[Course]:
    if around.scenario.course:
        return read_course(places.course_file(around.scenario.course, around.beside))
    return read_course(around.place.road) if around.place.road else None


def _line(car: Car, driver: DriverPlan, around: Surroundings) -> Optional[Path]:
    if not driver.takes("line"):
        return None
    path = places.course_file(car.line, around.beside) if car.line else around.place.line
    if path is not None:
        read_raceline(path)
    return path
