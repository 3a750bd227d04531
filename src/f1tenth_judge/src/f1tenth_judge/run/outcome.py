"""What is made of a run that is over: the judged result, and the files of its record."""

import itertools
from collections.abc import Mapping
from pathlib import Path
from typing import Callable, Optional

from f1tenth_judge.errors import MapError, ScenarioError
from f1tenth_judge.judge import criteria
from f1tenth_judge.judge.criterion import Measured
from f1tenth_judge.judge.driving_criteria import least_clearance
from f1tenth_judge.judge.judge import broken, finishes, judge
from f1tenth_judge.judge.laps import lap_times, start_of_race
from f1tenth_judge.judge.quickest_lap import impossible_laps
from f1tenth_judge.judge.road import excursions
from f1tenth_judge.places.map_file import Grid, load_map
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.files import PICTURE_FILE, REPLAY_FILE, TRAJECTORY_FILE
from f1tenth_judge.record.observations import Failure, Observations
from f1tenth_judge.record.replay import Poses, Replay, write_replay
from f1tenth_judge.results.reference_laps import quicker_than_reference
from f1tenth_judge.results.result import Result, write_trajectory
from f1tenth_judge.results.standing import name_of
from f1tenth_judge.scenario.scenario import Verdict
from f1tenth_judge.stop_request import StopRequest

Files = Mapping[str, Callable[[Path], None]]  # what writes a file of the results, by its name


def judged(
    plan: Plan,
    seen: Observations,
    real_time_factor: Optional[float],
    estimates: Mapping[str, Poses],
) -> Result:
    """The result of a run; `estimates`: where localization or odometry took the cars to be."""
    judgement = judge(plan.scenario, plan.tasks, seen)
    deciding, scenario = judgement.decision.stamp, plan.scenario
    racing = {car: task for car, task in plan.tasks.items() if not task.is_empty}
    laps = lap_times(scenario, plan.tasks, judgement, seen.updates)
    if judgement.decision.verdict is Verdict.SUCCESS:
        for problem in itertools.islice(impossible_laps(plan, judgement.record, laps), 1):
            judgement = broken(judgement, Failure("runner", problem))
    measured = Measured(
        start=start_of_race(plan.tasks, judgement, seen.updates),
        lap_times=laps,
        real_time_factor=real_time_factor,
        finishes=finishes(scenario.criteria, racing, judgement.record),
        estimates={car: poses.until(deciding) for car, poses in estimates.items()},
        excursions=tuple(excursions(plan.course, judgement.record.tracks.values())) if plan.course else None,
    )
    found = tuple(criteria.evaluate(plan.scenario, judgement, measured))
    note = "; ".join(filter(None, (plan.note, quicker_than_reference(plan.scenario, laps))))
    return Result(plan.name, plan.scenario, judgement, found, measured, note=note)


def files_of_record(plan: Plan, done: Result, picture: Callable) -> Files:
    """What is made from the record alone; `picture` gives the module results.picture."""
    record = done.judgement.record
    lines = (f"{done.judgement.decision.verdict.value}: {done.reason}", _facts(done))

    def write_picture(path):
        names = {car.name: name_of(car) for car in plan.scenario.cars}
        picture().write_picture(path, plan.name, lines, record, plan.goals, track_map(plan), names)

    return {TRAJECTORY_FILE: lambda path: write_trajectory(path, record), PICTURE_FILE: write_picture}


def write_scene(path: Path, plan: Plan, done: Result, scene: Replay, said: Replay) -> None:
    """Write the replay: `scene` stood around the cars, `said` is what planners and models told."""
    replay = scene.with_run(plan.goals, said, _road(plan))
    write_replay(path, replay.until(done.judgement.decision.stamp))


def worth_a_wait(files: Files, stop: StopRequest) -> Files:
    """The files, without those that take long if somebody waits for the end."""
    slow = (PICTURE_FILE, REPLAY_FILE) if stop.signal else ()
    return {name: _leave_out if name in slow else write for name, write in files.items()}


def track_map(plan: Plan) -> Optional[Grid]:
    """The map of the place; None if it has none that can be read."""
    try:
        return load_map(plan.place.map) if plan.place.map else None
    except MapError:
        return None


def _leave_out(_path: Path) -> None:
    raise ScenarioError("the run was told to stop")


def _road(plan: Plan) -> list[tuple[float, float]]:
    course = plan.course
    return [] if course is None else [(round(x, 2), round(y, 2)) for x, y in zip(course.x, course.y)]


def _facts(done: Result) -> str:
    facts = [
        ("lap time", done.best_lap_time, "s"),
        ("minimum clearance", least_clearance(done.judgement), "m"),
    ]
    return ", ".join(f"{name} {value:.3f} {unit}" for name, value, unit in facts if value is not None)
