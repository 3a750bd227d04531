"""Results folders made up for tests of the report."""

import json
import math

from f1tenth_scenarios.record.replay import REPLAY_FILE, Paths, Poses, Replay, Scans, Shape, write_replay
from scenario_samples import PERIOD, write_record

SQUARE = [(-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2)]
RADIUS = 3.0  # m, of the circle that the cars drive


def circling(end, car="robot1", speed=1.5):
    """A car on a circle around the origin, one row a period up to `end` (s)."""
    for index in range(1, round(end / PERIOD) + 1):
        time = index * PERIOD
        turn = speed * time / RADIUS
        x, y, yaw = RADIUS * math.cos(turn), RADIUS * math.sin(turn), turn + math.pi / 2
        clearance = 0.5 + 0.3 * math.sin(3 * turn)
        yield [f"{time:.9f}", car, x, y, yaw, speed, 0, speed / RADIUS, 0.1, clearance, "", f"hash{index}"]


def replay(end):
    """Everything that a replay can show."""
    stamps = [index / 10 for index in range(int(end * 10))]
    ranges = [[round(100 * (2 + math.sin(beam / 9 + stamp))) for beam in range(109)] for stamp in stamps]
    line = [(RADIUS * math.cos(turn / 9), RADIUS * math.sin(turn / 9)) for turn in range(57)]
    return Replay(
        walls=Shape([[(-5, -5), (5, -5), (5, -4.8), (-5, -4.8)]], [(0.0, 0.0, 1.0)]),
        goals={"robot1": [(0.0, RADIUS, math.pi), (-RADIUS, 0.0, -math.pi / 2)]},
        scans={"robot1": Scans(stamps, ranges, -2.35, 2.35, (0.27, 0.0, 0.0))},
        global_plans={"robot1": Paths([0.0], [line])},
        local_plans={"robot1": Paths([0.0, 1.0], [line[:10], line[5:20]])},
        models={"box": Poses([0.0, 1.0], [(2.0, 2.0, 0.0), (2.1, 2.0, 0.1)], Shape([SQUARE]))},
    )


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
                "reason": "as it says",
            }
        ],
        "times": {"start": 0.0, "finish": 10.0, "lap_time": 9.5, "wall": 4.2},
        "cars": {"robot1": {"lap_times": [9.5], "goals_passed": [4.0, 8.0]}},
        "minimum_clearance": 0.2,
        "contacts": [] if passed else [contact()],
        "real_time_factor": 12.5,
        "seed": 1,
        "trajectory_hash": f"hash of {commit}",
        "versions": {"commit": commit},
        **others,
    }


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
    (folder / "result.json").write_text(json.dumps(content), encoding="utf-8")
    write_record(folder / "trajectory.csv", circling(end, speed=speed))
    write_replay(folder / REPLAY_FILE, replay(end))
    return folder
