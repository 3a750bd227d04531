"""Laps: driven once by a driver who looks at the scan, then measured by giving the same commands again.

So the measured time is that of the simulator alone; the trajectory hash shows that the laps are the same.
"""

from dataclasses import dataclass

import numpy as np
from f1tenth_gazebo.driving.gap_follower import GapFollower, GapFollowerOptions

PERIOD = 0.025
"""s, of a lidar at 40 Hz."""
DRIVER = GapFollowerOptions(speed=4.0, max_lateral_acceleration=4.0)


@dataclass(frozen=True)
class Laps:
    """What was driven."""

    period: float
    """s, from one command to the next."""
    commands: list
    """A list per period: (speed, steering angle) of each car, m/s and rad."""
    poses: np.ndarray
    """Shape (periods, cars, 3): x, y, yaw at the end of each period, m and rad."""
    trajectory_hash: str


def record(simulation, seconds, period=PERIOD):
    """Let a gap follower drive every car from the start on; return the Laps."""
    drivers = [_driver(simulation.car(car).lidars[0]) for car in simulation.cars]
    commands, poses = [], []
    for step in range(round(seconds / period)):
        cars = simulation.cars
        commands.append([driver.command(simulation.scan(car)) for car, driver in zip(cars, drivers)])
        for car, command in zip(cars, commands[-1]):
            simulation.command(car, *command)
        simulation.advance_to((step + 1) * period)
        poses.append(simulation.poses())
    return Laps(period, commands, np.array(poses), simulation.trajectory_hash())


def replay(simulation, laps):
    """Drive the laps again from a reset on, with a noisy scan of every car each period."""
    cars = simulation.cars
    buffers = [np.empty(simulation.car(car).lidars[0].beam_count, np.float32) for car in cars]
    command, advance_to, scan = simulation.command, simulation.advance_to, simulation.scan
    simulation.reset()
    for step, row in enumerate(laps.commands, 1):
        for car, wanted in zip(cars, row):
            command(car, *wanted)
        advance_to(step * laps.period)
        for car, buffer in zip(cars, buffers):
            scan(car, 0, buffer)


def _driver(lidar):
    increment = (lidar.angle_max - lidar.angle_min) / (lidar.beam_count - 1)
    return GapFollower(lidar.angle_min, increment, lidar.beam_count, DRIVER)
