"""What a run needs to know about one of its cars."""

import dataclasses
from pathlib import Path
from typing import Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.places.course import Course, read_course
from f1tenth_judge.places.goals import goals_along, read_goals
from f1tenth_judge.places.place import Place, gates_after, line_across
from f1tenth_judge.places.raceline import read_raceline
from f1tenth_judge.plan.car_description import CarDescription, read_description
from f1tenth_judge.plan.driver_file import DriverFile
from f1tenth_judge.plan.task import Task
from f1tenth_judge.scenario.car import Car, Pose
from f1tenth_judge.scenario.scenario import Scenario, StartLine


@dataclasses.dataclass(frozen=True)
class CarPlan:
    """A car with everything that its driver and its judge must know."""

    start: Pose
    driver: DriverFile
    goals_file: Optional[Path]  # nothing when it has no goals, or they are in no file
    goals: tuple[Pose, ...]  # of one lap
    line: Optional[Path]  # that it may follow
    task: Task
    description: Optional[CarDescription] = None  # nothing for the F1/10 car


@dataclasses.dataclass(frozen=True)
class Surroundings:
    """Where all cars of a scenario drive."""

    scenario: Scenario
    place: Place
    course: Optional[Course]  # nothing where no road is known
    beside: Path  # folder that paths are relative to
    has_countdown: bool  # whether somebody waits for a start signal


def plan_car(car: Car, driver: DriverFile, around: Surroundings) -> CarPlan:
    """Find and read what a scenario says about a car.

    Raises:
        ScenarioError: what is wrong.
    """
    goals_file, goals = _goals(car, driver, around)
    return CarPlan(
        start=car.start or _start(car, around.place),
        driver=driver,
        goals_file=goals_file,
        goals=goals,
        line=_line(car, driver, around),
        task=_task(car, driver, goals, around),
        description=read_description(car, around.beside),
    )


def _start(car: Car, place: Place) -> Pose:
    return place.ahead_of_start(car.ahead) if car.ahead else place.start()


def _goals(car: Car, driver: DriverFile, around: Surroundings) -> tuple[Optional[Path], tuple[Pose, ...]]:
    """The goals file, and what is in it; for a driver that cannot do without, those of the road."""
    place = around.place
    if car.goals:
        path = lookup.goals_file(car.goals, around.beside)
    elif "goals_file" not in driver.required or place.road is None:
        return None, ()
    elif place.is_circuit:
        path = lookup.goals_file(place.world.stem, around.beside)
    else:
        return None, goals_along(read_course(place.road))
    return path, tuple(read_goals(path))


def _task(car: Car, driver: DriverFile, goals: tuple[Pose, ...], around: Surroundings) -> Task:
    line = _start_line(around) if car.laps else None
    return Task(
        goals=() if car.laps else goals * around.scenario.laps,
        laps=car.laps or 0,
        line=line,
        gates=gates_after(around.course, line) if around.course and line else (),
        obeys_start=around.has_countdown and driver.obeys_start,
        reports=driver.needs_countdown,
    )


def _start_line(around: Surroundings) -> StartLine:
    if around.scenario.start_line:
        return around.scenario.start_line
    if around.course is None:
        raise ScenarioError(f"'laps' of a car needs a 'start_line' or a 'course': {around.place.no_road}")
    return line_across(around.course, around.place.start())


def _line(car: Car, driver: DriverFile, around: Surroundings) -> Optional[Path]:
    if "line" not in driver.arguments:
        return None
    path = lookup.course_file(car.line, around.beside) if car.line else around.place.line_for(car.driver)
    if path is not None:
        read_raceline(path)
    return path
