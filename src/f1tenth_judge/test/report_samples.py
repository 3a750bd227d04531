"""Results folders made up for tests of the report."""

import base64
import io
import math

import numpy as np
from f1tenth_judge.record.files import REPLAY_FILE
from f1tenth_judge.record.replay import Drawing, Numbers, Poses, Replay, Shape, Timed, write_replay
from f1tenth_judge.results.result_file import write_result
from PIL import Image
from scenario_samples import PERIOD, write_record

SQUARE = [(-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2)]
RADIUS = 3.0  # m, of the circle that the cars drive


def circling(end, car="robot1", speed=1.5):
    """A car on a circle around the origin, one row per period up to `end` (s)."""
    for index in range(1, round(end / PERIOD) + 1):
        time = index * PERIOD
        turn = speed * time / RADIUS
        x, y, yaw = RADIUS * math.cos(turn), RADIUS * math.sin(turn), turn + math.pi / 2
        clearance = 0.5 + 0.3 * math.sin(3 * turn)
        yield [f"{time:.9f}", car, x, y, yaw, speed, 0, speed / RADIUS, 0.1, clearance, "", 0, f"hash{index}"]


def replay(end):
    """Everything that a replay can show."""
    line = [(RADIUS * math.cos(turn / 9), RADIUS * math.sin(turn / 9)) for turn in range(57)]
    return Replay(
        walls=Shape([[(-5, -5), (5, -5), (5, -4.8), (-5, -4.8)]], [(0.0, 0.0, 1.0)]),
        goals={"robot1": [(0.0, RADIUS, math.pi), (-RADIUS, 0.0, -math.pi / 2)]},
        road=[(RADIUS * math.cos(turn / 9), RADIUS * math.sin(turn / 9)) for turn in range(56)],
        lidars={"robot1": (-2.35, 2.35, 0.27, 0.0, 0.0, 10.0)},
        global_plans={"robot1": Timed([0.0], [line])},
        local_plans={"robot1": Timed([0.0, 1.0], [line[:10], line[5:20]])},
        drawings={"/robot1/candidates": Timed([0.0, 5.0], [[candidates()], []])},
        channels={"/robot1/error": Numbers([0.0, 5.0], [0.25, -0.5], "robot1")},
        pictures={"/robot1/camera/image_raw": Timed([0.5, 5.0], [picture("red"), picture("blue")])},
        models={"box": Poses([0.0, 1.0], [(2.0, 2.0, 0.0), (2.1, 2.0, 0.1)], Shape([SQUARE]))},
    )


def candidates():
    return Drawing("#00aa00", [[(3.0, 0.0), (3.0, 2.0)]], [(2.0, 3.0, 0.2)], [(1.0, 2.0, "brake")])


def picture(colour):
    stream = io.BytesIO()
    Image.new("RGB", (160, 120), colour).save(stream, "JPEG")
    return base64.b64encode(stream.getvalue()).decode("ascii")


def result(name, passed=True, commit="0123456789ab", **others):
    """The content of a result.json."""
    verdict = "success" if passed else "collision"
    return {
        "scenario": name,
        "description": "A car drives in a circle.",
        "world": "circuit1",
        "verdict": verdict,
        "expected": "success",
        "passed": passed,
        "reason": "every goal was passed in order" if passed else "robot1 touched </script> at 1.000 s",
        "culprit": None,
        "criteria": [
            {
                "name": "verdict",
                "status": "passed" if passed else "failed",
                "actual": verdict,
                "limit": "success",
                "unit": "",
                "reason": "every goal was passed in order"
                if passed
                else "robot1 touched </script> at 1.000 s",
            },
            {
                "name": "minimum_clearance",
                "status": "passed",
                "actual": 0.2,
                "limit": 0.1,
                "unit": "m",
                "reason": "came as close as 0.200 m",
            },
        ],
        "times": {"start": 0.0, "finish": 10.0, "lap_time": 9.5, "wall": 4.2, "cost": 3.4},
        "cars": {"robot1": {"lap_times": [9.5], "goals_passed": [4.0, 8.0]}},
        "minimum_clearance": 0.2,
        "contacts": [] if passed else [contact()],
        "real_time_factor": 12.5,
        "seed": 1,
        "trajectory_hash": f"hash of {commit}",
        "versions": {"commit": commit, "driver_commits": {"robot1": commit}},
        **others,
    }


def race_result(name, **others):
    """The content of a result.json of two cars."""
    cars = {
        "robot1": {**driven_by("/robots/gap.py:Gap", "Python class"), "lap_times": [9.5], "finish": 9.5},
        "robot2": {**driven_by("race", "launch file of ROS 1"), "lap_times": [10.75], "finish": 10.75},
    }
    winner = {"car": "robot1", "second": "robot2", "ahead": 1.25}
    return result(name, cars=cars, winner=winner, **others)


def driven_by(planner, kind):
    return {"planner": planner, "driver": kind, "description": "the F1/10 car"}


def failed_criteria(name):
    """The content of a result.json whose verdict is as expected and whose criteria are not met."""
    content = result(name, passed=False, verdict="success", reason="came as close as 0.076 m")
    verdict, clearance = content["criteria"]
    verdict.update(status="passed", actual="success")
    clearance.update(status="failed", actual=0.0763219, reason="came as close as 0.076 m")
    lap = {"name": "lap_time", "status": "failed", "actual": 9.5, "limit": 9, "unit": "s"}
    content["criteria"].append({**lap, "reason": "lap 1 of robot1 took 9.500 s"})
    return content


def contact():
    return {
        "car": "robot1",
        "start": 1.0,
        "end": 1.1,
        "touched": ["Wall_1"],
        "x": 1.0,
        "y": 1.0,
        "speed": 1.5,
    }


def write_run(folder, content, end=10.0, speed=1.5):
    """A results folder of one run."""
    folder.mkdir(parents=True)
    write_result(folder / "result.json", content)
    write_record(folder / "trajectory.csv", circling(end, speed=speed))
    write_replay(folder / REPLAY_FILE, replay(end))
    return folder


def write_race(folder, content, end=10.0):
    """A results folder of a race of two: robot2 drives 0.5 m/s slower and is 5 m behind after 10 s."""
    write_run(folder, content)
    write_record(folder / "trajectory.csv", circling(end), circling(end, "robot2", speed=1.0))
    return folder


def write_long_run(folder, content, seed, end=120.0):
    """Two minutes of a car that drives less evenly than any planner, with a plan in each period."""
    random = np.random.default_rng(seed)
    write_run(folder, content)
    count = round(end / PERIOD)
    speeds = 4.0 + np.cumsum(random.normal(0.0, 0.05, count)) % 4.0
    turns = np.cumsum(speeds) * PERIOD / RADIUS
    swerves = RADIUS + np.cumsum(random.normal(0.0, 0.005, count))
    rows = [
        [
            f"{(index + 1) * PERIOD:.9f}",
            "robot1",
            swerve * math.cos(turn),
            swerve * math.sin(turn),
            turn + 1.57,
            speed,
        ]
        + [0, speed / RADIUS, 0.1 * math.sin(turn), 0.3 + 0.1 * math.cos(3 * turn), "", 0, f"hash{index}"]
        for index, (turn, swerve, speed) in enumerate(zip(turns, swerves, speeds))
    ]
    write_record(folder / "trajectory.csv", rows)
    plans = [
        [(swerve * math.cos(turn + ahead / 9), swerve * math.sin(turn + ahead / 9)) for ahead in range(40)]
        for turn, swerve in zip(turns, swerves)
    ]
    stamps = [(index + 1) * PERIOD for index in range(count)]
    write_replay(folder / REPLAY_FILE, Replay(local_plans={"robot1": Timed(stamps, plans)}))
    return folder
