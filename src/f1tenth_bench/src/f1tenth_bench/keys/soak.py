"""soak_growth: half an hour of simulated time in free mode."""

import csv
import math
import signal
import time

from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.keys.node import INFIELD
from f1tenth_bench.places import circuit_file, executable
from f1tenth_bench.ros.ros_run import RosRun, end, resident_megabytes
from f1tenth_bench.ros.ros_speed import RADIUS

SECONDS = 1800.0  # simulated
WARM_UP = 200.0  # simulated s, in which buffers reach their size
DRIFT_MAX = 0.01  # m, of the circle's radius from the first round to the last


@benchmark("soak_growth", "%", at_most=1, is_ratio=True)
def soak_growth():
    """Growth of the node's resident set while a car circles before a C++ subscriber of everything."""
    with RosRun() as run:
        record = run.folder / "record.csv"
        start = (INFIELD[0], INFIELD[1] - RADIUS, 0.0)
        world = circuit_file("circuit1")
        sim2d = run.start_sim2d(world, pose=start, paused=True, real_time_factor=0.0, record=str(record))
        run.wait_for_service("/gazebo/unpause_physics")
        listener = run.start([executable("listener", "f1tenth_bench"), "robot1"])
        listener.stdout.readline()
        _wait_until(record, WARM_UP)
        before = resident_megabytes(sim2d)
        _wait_until(record, SECONDS)
        after = resident_megabytes(sim2d)
        listener.send_signal(signal.SIGINT)
        listener.stdout.readline()  # it says when it has paused the simulator, and ends after it
        end(sim2d)
        rows = list(csv.DictReader(record.open()))
    growth = 100.0 * (after / before - 1.0)
    details = {
        "resident_mb": [before, after],
        "simulated_seconds": float(rows[-1]["time"]),
        "drift_m": _drift(rows),
    }
    return Measured(growth, details, _problem(rows, details))


def _wait_until(record, seconds):
    """Block until the record has reached a simulated time."""
    while True:
        last = (
            record.read_bytes()[-4096:].decode(errors="ignore").splitlines()[:-1] if record.exists() else []
        )
        if last and last[-1][:1].isdigit() and float(last[-1].split(",")[0]) >= seconds:
            return
        time.sleep(0.2)


def _drift(rows):
    """How much the circle of the last 10 s differs from that of as many after the warm-up, m."""
    periods = 400
    first = round(WARM_UP / 0.025)
    early, late = (_circle(part) for part in (rows[first : first + periods], rows[-periods:]))
    return max(abs(a - b) for a, b in zip(early, late))


def _circle(rows):
    """Bounds of a path: least and largest x and y, m."""
    x, y = ([float(row[key]) for row in rows] for key in "xy")
    return min(x), max(x), min(y), max(y)


def _problem(rows, details):
    if any(float(row["time"]) != float(f"{number * 0.025:.9f}") for number, row in enumerate(rows, 1)):
        return "the times of the record are not multiples of the period"
    if not math.isfinite(details["drift_m"]) or details["drift_m"] > DRIFT_MAX:
        return f"the car has drifted by {details['drift_m']:.3f} m"
    return ""
