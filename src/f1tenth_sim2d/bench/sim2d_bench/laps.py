"""Laps: driven once by a driver who looks at the scan, then measured by giving the same commands again.

So the measured time is that of the simulator alone; the trajectory hash shows that the laps are the same.
"""

import math
from dataclasses import dataclass

import numpy as np

PERIOD = 0.025
"""s, of a lidar at 40 Hz."""


class GapFollower:
    """Steers to where it is free farthest, with a window of the car's width swept along the scan."""

    SPEED_MAX = 4.0  # m/s
    SIGHT = 8.0  # m
    HALF_WINDOW = math.radians(9.0)
    LOOK_ASIDE = math.radians(70.0)
    GAIN = 1.2
    STEERING_MAX = 0.4  # rad

    def __init__(self, lidar):
        """Take the Lidar whose scans are given later."""
        angles = np.linspace(lidar.angle_min, lidar.angle_max, lidar.beam_count)
        self._ahead = np.abs(angles) <= self.LOOK_ASIDE
        self._angles = angles[self._ahead]
        self._half = max(1, round(self.HALF_WINDOW / (angles[1] - angles[0])))

    def command(self, ranges):
        """(speed, steering angle), m/s and rad, for a scan, m."""
        ahead = np.clip(ranges[self._ahead], 0.1, self.SIGHT).astype(float)
        padded = np.pad(ahead, self._half, mode="edge")
        free = np.lib.stride_tricks.sliding_window_view(padded, 2 * self._half + 1).min(axis=1)
        aim = float(np.average(self._angles, weights=free**4))
        steering = min(max(self.GAIN * aim, -self.STEERING_MAX), self.STEERING_MAX)
        return self.SPEED_MAX / (1.0 + 2.0 * abs(steering)), steering


@dataclass(frozen=True)
class Laps:
    """What was driven."""

    period: float
    """s, from one command to the next."""
    commands: list
    """A list a period: (speed, steering angle) of each car, m/s and rad."""
    poses: np.ndarray
    """Shape (periods, cars, 3): x, y, yaw at the end of each period, m and rad."""
    trajectory_hash: str


def record(simulation, seconds, period=PERIOD):
    """Let a gap follower drive every car from the start on; return the Laps."""
    drivers = [GapFollower(simulation.car(car).lidars[0]) for car in simulation.cars]
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
