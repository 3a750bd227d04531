"""Speed of the node with a C++ node that listens to everything."""

import json
import signal
import time

from f1tenth_bench.benchmark import Measured
from f1tenth_bench.places import executable
from f1tenth_bench.ros.ros_run import LONG, RosRun, end, processor_seconds, resident_megabytes
from f1tenth_bench.simulator.cars import F1TENTH

RADIUS = 0.75  # m, of the circle that listener drives


def measure_node(world, wall_seconds, lidar=F1TENTH, centre=(0.0, 0.0), **parameters):
    """Let one car circle to the left, 0.75 m about a point, before a C++ subscriber of all its topics.

    Returns:
        dict: Simulated and wall seconds, processor time, memory, messages published and received, problem.
    """
    with RosRun() as run:
        sim2d = run.start_sim2d(world, lidar, (centre[0], centre[1] - RADIUS, 0.0), paused=True, **parameters)
        run.wait_for_service("/gazebo/unpause_physics")
        listener = run.start([executable("listener", "f1tenth_bench"), "robot1"])
        listener.stdout.readline()  # it says when it has set the simulator going
        cpu = processor_seconds(sim2d)
        time.sleep(wall_seconds)
        cpu = processor_seconds(sim2d) - cpu
        resident = resident_megabytes(sim2d)
        listener.send_signal(signal.SIGINT)
        listener.stdout.readline()  # it says when it has paused the simulator
        end(sim2d)
        heard = json.loads(listener.communicate(timeout=LONG)[0])
        result = run.result()
    received, missing = (sum(heard[kind].values()) for kind in ("received", "missing"))
    return {
        "simulated_seconds": result["sim_time"],
        "wall_seconds": heard["wall_seconds"],
        "cpu_seconds_per_wall_second": cpu / wall_seconds,
        "resident_mb": resident,
        "messages": received + missing,
        "received_percent": 100.0 * received / (received + missing),
        "problem": _problem(heard["missing"]),
    }


def _problem(missing):
    """Say which messages were not received; "" if all were."""
    found = [f"{count} of {topic}" for topic, count in sorted(missing.items()) if count]
    return f"not received: {', '.join(found)}" if found else ""


def real_time_factor(world, wall_seconds=10.0, **options):
    """Simulated seconds per wall second in free mode, if nothing was lost."""
    found = measure_node(world, wall_seconds, real_time_factor=0.0, **options)
    return Measured(found["simulated_seconds"] / found["wall_seconds"], found, found["problem"])
