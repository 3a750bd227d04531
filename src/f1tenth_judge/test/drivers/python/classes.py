"""Planners for tests."""

import os
import sys
import time
import zlib

import numpy as np
from f1tenth_judge.planner import Command


class Follower:
    """Steers to where it is free; knows its way by the scan alone."""

    def plan(self, observation):
        scan = observation.scan
        angles = scan.angles[np.abs(scan.angles) < 1.3]
        view = np.clip(scan.ranges[np.abs(scan.angles) < 1.3], 0.0, 5.0)
        nearest = np.argmin(view)
        view[np.abs(angles - angles[nearest]) < np.arctan2(0.5, view[nearest])] = 0.0
        view[view < 1.2] = 0.0
        steering = float(np.clip(0.9 * np.average(angles, weights=view + 1e-6), -0.4, 0.4))
        return Command(1.5, steering)


class Pursuer:
    """Goes by its pose: from one point of the centreline to the next."""

    def reset(self, info):
        self._line = np.loadtxt(info["line"], delimiter=",")[:, :2]

    def plan(self, observation):
        x, y, yaw = observation.pose
        nearest = int(np.argmin(np.hypot(*(self._line - (x, y)).T)))
        ahead = self._line[(nearest + 5) % len(self._line)] - (x, y)
        turn = np.arctan2(ahead[1], ahead[0]) - yaw
        return 2.0, float(np.clip(np.arctan2(np.sin(turn), np.cos(turn)), -0.4, 0.4))


class Telling(Follower):
    """Says what it is told."""

    def reset(self, info):
        print(info["car_name"], info["laps"], info["word"], info["odometry"])

    def plan(self, observation):
        x, y, _ = observation.pose
        if observation.time < 0.03:
            print(f"{observation.time:g} {x:g} {y:g} {observation.velocity} {observation.imu.shape}")
            print(
                observation.scan.ranges.shape,
                observation.scan.ranges.dtype,
                f"{observation.scan.range_max:g}",
            )
        return super().plan(observation)


class Noting(Follower):
    """Shows what it thinks of."""

    def plan(self, observation):
        x, y, _ = observation.pose
        ahead = np.array([(x, y), (x + 1.0, y), (np.nan, y)])
        self.notes = {
            "turn": np.float32(observation.time > 0.3) / 2,
            "target": (x + 1.0, y),
            "way": ahead,
            "none": [],
        }
        return super().plan(observation)


class NotesWords(Follower):
    notes = {"state": "braking"}


class Looker:
    """Says what it sees in its second period."""

    def reset(self, info):
        self._eyes = info["eyes"]

    def plan(self, observation):
        if 0.04 < observation.time < 0.06:
            print([(eye.camera, eye.name, eye.width, eye.height) for eye in self._eyes])
            print(observation.camera.shape, observation.camera.dtype, zlib.crc32(observation.camera))
            print(observation.depth.shape, observation.depth.dtype, zlib.crc32(observation.depth))
            print(zlib.crc32(observation.look(eye="right").depth))
        return Command(1.0, 0.2)


class LooksElsewhere:
    def plan(self, observation):
        return Command(observation.look("roof").depth.max(), 0.0)


class LooksBack:
    last = None

    def plan(self, observation):
        if self.last:
            self.last.look()
        self.last = observation
        return Command(0.0, 0.0)


class DiesAtOnce:
    def __init__(self):
        raise ValueError("no model weights in /models")


class Raises:
    def plan(self, observation):
        return observation.scan.range[0]


class Exits:
    def plan(self, observation):
        os._exit(3)


class Ends:
    def plan(self, observation):
        sys.exit("enough")


class ReturnsNothing:
    def plan(self, observation):
        pass


class SaysNan:
    def plan(self, observation):
        return Command(float("nan"), 0.0)


class NeverReturns:
    def plan(self, observation):
        while True:
            time.sleep(0.01)


class NeverIsReady:
    def reset(self, info):
        while True:
            time.sleep(0.01)

    def plan(self, observation):
        return Command(0.0, 0.0)


class ForksAndExits:
    def plan(self, observation):
        if os.fork() == 0:
            time.sleep(60.0)
        os._exit(4)
