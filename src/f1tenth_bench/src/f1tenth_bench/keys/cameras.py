"""stereo_ms: what the stereo camera of the workspace's car costs."""

import numpy as np
from f1tenth_judge.places.lookup import package_path

import f1tenth_sim2d
from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.places import circuit_file
from f1tenth_bench.simulator.cars import f1tenth_car
from f1tenth_bench.timing import processor_seconds

PLACES = 20
REPEATS = 3


@benchmark("stereo_ms", "ms", at_most=20)
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

    return Measured(processor_seconds(look_everywhere, REPEATS) / PLACES * 1e3, {"places": PLACES})
