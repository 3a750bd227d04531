"""stereo_ms, stereo_rtf: what the stereo camera of the workspace's car costs."""

import tempfile
import time

import numpy as np
import psutil
from f1tenth_judge.places.lookup import package_path

import f1tenth_sim2d
from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.judged import judged
from f1tenth_bench.places import circuit_file
from f1tenth_bench.ros.ros_run import resident_megabytes
from f1tenth_bench.simulator import seeing_driver
from f1tenth_bench.simulator.cars import f1tenth_car
from f1tenth_bench.timing import processor_seconds

PLACES = 20
REPEATS = 3
LAPS = 3


@benchmark("stereo_ms", "ms", at_most=15)
def stereo_ms():
    """Colour and depth of both eyes in circuit_detailed, mean over places along its centreline."""
    world = f1tenth_sim2d.load_world(str(circuit_file("circuit_detailed")))
    line = f1tenth_sim2d.read_centreline(
        package_path("f1tenth_gazebo") / "worlds/circuit_detailed_centerline.csv"
    )
    simulation = f1tenth_sim2d.Simulation(world)
    car = simulation.add_car(f1tenth_car(), None, *world.start)
    steps = np.linspace(0, len(line) - 2, PLACES).astype(int)
    poses = [(*line[i, :2], np.arctan2(*(line[i + 1, :2] - line[i, :2])[::-1])) for i in steps]

    def look_everywhere():
        for pose in poses:
            simulation.place_car(car, *map(float, pose))
            for eye in ("left", "right"):
                simulation.look(car, "stereo_camera", eye)

    process = psutil.Process()
    began, before = time.perf_counter(), resident_megabytes(process)
    simulation.look(car, "stereo_camera", "left")
    details = {
        "places": PLACES,
        "first_look_s": time.perf_counter() - began,
        "scene_mb": resident_megabytes(process) - before,
    }
    return Measured(processor_seconds(look_everywhere, REPEATS) / PLACES * 1e3, details)


@benchmark("stereo_rtf", "sim s / s", at_least=2)
def stereo_rtf():
    """Of laps of circuit_detailed by a planner that looks at both eyes at 30 Hz, one after the other."""
    planner = f"{seeing_driver.__file__}:SeeingDriver"
    with tempfile.TemporaryDirectory() as folder:
        result = judged(folder, "race", "race", "circuit_detailed", "--planner", planner, "--laps", str(LAPS))
    return Measured(
        result["real_time_factor"],
        {"sim_s": result["times"]["finish"]},
        problem="" if result["passed"] else result["reason"],
    )
