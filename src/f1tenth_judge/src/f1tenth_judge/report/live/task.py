"""What the process that serves the watchers needs to know of a run."""

import dataclasses
from typing import Any

import f1tenth_sim2d
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.record import Record
from f1tenth_judge.record.replay import Replay
from f1tenth_judge.record.scene import scene_of
from f1tenth_judge.report.replay_columns import pack_run, pack_world
from f1tenth_judge.results.standing import who
from f1tenth_judge.run.stage import models_folder, own_car


def task_of(plan: Plan) -> dict[str, Any]:
    """Of a run that is planned."""
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
    }


def scene_of_task(task) -> dict[str, Any]:
    """What stands around the cars, and who drives them, as the page of a report has it."""
    descriptions = {name: each or own_car() for name, each in task["descriptions"].items()}
    cars = {name: f1tenth_sim2d.load_car(text, name, file) for name, (text, file) in descriptions.items()}
    try:
        scene = scene_of(f1tenth_sim2d.load_world(task["world"], [str(models_folder())]), cars)
    except f1tenth_sim2d.Error:
        scene = Replay()  # the run says what is wrong with it
    shown = dataclasses.replace(scene, goals=task["goals"], road=task["road"])
    about = {key: task[key] for key in ("description", "cars")}
    return {"columns": pack_run(Record({}), shown), "world": pack_world(shown), "about": about}
