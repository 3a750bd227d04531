"""physics_step: what longer physics steps cost in accuracy, and what they save."""

import math

import numpy as np
from f1tenth_sim2d.environments.car import Lidar, load_cars

import f1tenth_sim2d
from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.timing import processor_seconds

STEPS = (0.001, 0.002, 0.005, 0.010)  # s
REFERENCE = 0.0001  # s
DRIVE, COMMANDS = 5.0, 0.05  # s: the manoeuvre, and how often it gives a command
IMPACTS = ((2.0, 0.0), (5.0, 0.0), (5.0, 0.6), (8.0, 1.0))  # m/s, and rad from square onto the wall
WALL = """<sdf version="1.6"><model name="wall"><static>true</static><link name="l"><collision name="c">
<geometry><box><size>0.1 40 1</size></box></geometry></collision></link></model></sdf>"""


@benchmark("physics_step", "mm", at_most=10, is_ratio=True)
def physics_step():
    """How far a slalom of 5 s at 5 m/s with steps of 1 ms ends from where one with steps of 0.1 ms does."""
    exact, blows = _slalom(REFERENCE), [_impact(REFERENCE, *each) for each in IMPACTS]
    details = {f"{1e3 * step:g} ms": _compared(step, exact, blows) for step in STEPS}
    return Measured(details["1 ms"]["end_off_mm"], details)


def _compared(step, exact, blows):
    poses = _slalom(step)
    ours = [_impact(step, *each) for each in IMPACTS]
    return {
        "end_off_mm": 1e3 * float(np.hypot(*(poses - exact)[-1, :2])),
        "path_off_mm": 1e3 * float(np.hypot(*(poses - exact)[:, :2].T).max()),
        "heading_off_deg": math.degrees(float(np.abs(poses - exact)[:, 2].max())),
        "touch_late_ms": 1e3 * max(abs(a["time"] - b["time"]) for a, b in zip(ours, blows)),
        "touch_off_mm": 1e3 * max(math.dist(a["place"], b["place"]) for a, b in zip(ours, blows)),
        "deepest_mm": 1e3 * max(a["depth"] for a in ours),
        "us_per_10_ms": processor_seconds(lambda: _slalom(step), 3) / DRIVE * 1e4,
    }


def _simulation(step, yaw=0.0):
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.empty_world(), physics_step=step)
    simulation.add_car(load_cars(["robot1"], Lidar(1, 0.1, 10.0))[0], None, 0.0, 0.0, yaw)
    return simulation


def _slalom(step):
    """Poses at each command; all steps divide the time between two."""
    simulation = _simulation(step)
    poses = []
    for i in range(round(DRIVE / COMMANDS)):
        simulation.command(0, 5.0, 0.12 * math.sin(2.0 * math.pi * i * COMMANDS / 2.5))
        simulation.advance_to((i + 1) * COMMANDS)
        poses.append(simulation.poses()[0])
    return np.unwrap(np.array(poses), axis=0, period=2.0 * math.pi, discont=math.pi)


def _impact(step, speed, angle):
    """Time and place of the first touch and the greatest depth of 0.3 s of driving into a wall."""
    simulation = _simulation(step, angle)
    simulation.add_model(f1tenth_sim2d.load_model(WALL, "wall", "bench", 2.0137)[0])
    simulation.place_car(0, 0.0, 0.0, angle, speed)
    first, depth = None, 0.0
    while first is None or simulation.time < first["time"] + 0.3:
        simulation.command(0, speed, 0.0)
        simulation.clear_contacts(0)
        simulation.step()
        for contact in simulation.contacts(0):
            first = first or {"time": simulation.time, "place": tuple(simulation.poses()[0][:2])}
            depth = max([depth, *contact.depths])
    return {**first, "depth": depth}
