"""One run without ROS: begin, drive, judge, keep."""

import contextlib
import dataclasses
import importlib
import time
from collections.abc import Mapping
from typing import Callable

from f1tenth_judge.errors import MismatchError, ScenarioError
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.planning import in_real_time
from f1tenth_judge.plan.scenario_world import write_world
from f1tenth_judge.record.files import DRAWINGS_FILE, REPLAY_FILE
from f1tenth_judge.record.observations import Failure, Observations
from f1tenth_judge.record.record import Record, read_record
from f1tenth_judge.record.scene import scene_of
from f1tenth_judge.results import versions
from f1tenth_judge.results.result import Result
from f1tenth_judge.results.results_folder import claimed
from f1tenth_judge.results.writing import write_rest, write_verdict
from f1tenth_judge.run.driver import Driver
from f1tenth_judge.run.loop import Loop, Progress
from f1tenth_judge.run.outcome import Files, files_of_record, judged, worth_a_wait, write_scene
from f1tenth_judge.run.stage import Stage
from f1tenth_judge.said.journal import Journal
from f1tenth_judge.said.said import Said
from f1tenth_judge.stop_request import StopRequest

Drivers = Callable[[Plan, Stage, StopRequest, contextlib.ExitStack], Mapping[str, Driver]]
"""Starts the driver of each car; what is to be closed at the end goes onto the stack."""


def execute(
    plan: Plan, make_drivers: Drivers, stop: StopRequest, progress: Progress = lambda simulated, wall: None
) -> Result:
    """Run a scenario and write its results.

    If a driver does not fit lockstep, the run begins anew in real time, and the result says so.

    Raises:
        ScenarioError: the results folder, the world, a car or a driver cannot be used.
    """
    started = time.monotonic()
    with claimed(plan.folder, plan.log_folder, versions.commits(plan.driver_folders)) as claim:
        if plan.scenario.boxes:
            write_world(plan.place.world, plan.scenario, plan.run_world)
        try:
            done, stage = _drive(plan, make_drivers, stop, progress)
        except MismatchError as mismatch:
            plan = in_real_time(plan, str(mismatch))
            done, stage = _drive(plan, make_drivers, stop, progress)
        # No run can be compared with one that was told to stop.
        folder = claim.place_of_interrupted() if stop.signal else claim.place_of_results()
        done = dataclasses.replace(done, folder=folder, wall_time=time.monotonic() - started)
        # First, because whatever else cannot be written must not cost the verdict.
        write_verdict(plan, done)
        problems = write_rest(folder, worth_a_wait(_files(plan, done, stage), stop))
        problems += tuple(f"{REPLAY_FILE}: {each}" for each in stage.said.left_out)
        done = dataclasses.replace(done, wall_time=time.monotonic() - started, not_written=problems)
        with contextlib.suppress(ScenarioError):  # what it wrote before was complete except for the time
            write_verdict(plan, done)
    return done


def _drive(plan: Plan, make_drivers: Drivers, stop: StopRequest, progress: Progress) -> tuple[Result, Stage]:
    """The run, judged, and its stage."""
    with contextlib.ExitStack() as stack:
        journal = stack.enter_context(contextlib.closing(Journal(plan.log_folder / DRAWINGS_FILE)))
        stage = Stage(plan, Said(journal.note))
        loop = Loop(plan, stage, stop, progress)
        drivers = make_drivers(plan, stage, stop, stack)
        failure = loop.run(drivers)
        notes = [driver.note() for driver in drivers.values()]
    if problem := loop.record.problem():  # of what somebody has changed, nothing can be believed
        seen = Observations(Record({}), failure=_tampering(plan, problem))
    else:
        seen = Observations(read_record(plan.record_file), failure=failure)
    done = judged(plan, seen, loop.pace.factor, {})
    done = dataclasses.replace(
        done,
        note="; ".join(filter(None, (done.note, *stage.chances, *notes))),
        inputs=stage.inputs,
        published=stage.said.replay(),
        is_repeatable=not stage.chances,
    )
    return done, stage


def _tampering(plan: Plan, problem: str) -> Failure:
    cars = [car.name for car in plan.scenario.cars]
    return Failure(f"{cars[0]}/planner" if len(cars) == 1 else "runner", problem, stamp=0.0)


def _files(plan: Plan, done: Result, stage: Stage) -> Files:
    # The module imports matplotlib.
    files = files_of_record(plan, done, lambda: importlib.import_module("f1tenth_judge.results.picture"))
    scene = scene_of(stage.world, stage.descriptions)
    return {**files, REPLAY_FILE: lambda path: write_scene(path, plan, done, scene, done.published)}
