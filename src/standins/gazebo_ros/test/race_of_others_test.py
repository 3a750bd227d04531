#!/usr/bin/env python3
"""A race in a workspace made for Gazebo, unmodified: three cars drive, and one learns by starting anew."""

import os
import pathlib
import signal
import subprocess
import threading
import unittest

import rospy
import rostest
from gazebo_msgs.msg import ContactsState, ModelStates
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Int32

LONG = 150.0  # wall s: only a hang takes that long
FIXTURE = pathlib.Path(__file__).resolve().parent / "race_of_others"
CARS = ("car1", "car2", "car3")
WAY = 5.0  # m, before the first corner: a planner that is delayed may stop before its wall for good


class Ways:
    """How far each model has gone."""

    def __init__(self):
        self._changed = threading.Condition()
        self._last = {}
        self.ways = {}
        self._subscriber = rospy.Subscriber("/gazebo/model_states", ModelStates, self._note)

    def _note(self, message):
        with self._changed:
            for name, pose in zip(message.name, message.pose):
                x, y = pose.position.x, pose.position.y
                last_x, last_y = self._last.get(name, (x, y))
                way = abs(complex(x - last_x, y - last_y))
                self.ways[name] = self.ways.get(name, 0.0) + (way if way < 0.5 else 0.0)
                self._last[name] = (x, y)
            self._changed.notify_all()

    def wait_for(self, names, way):
        with self._changed:
            done = self._changed.wait_for(lambda: all(self.ways.get(name, 0.0) > way for name in names), LONG)
        assert done, self.ways


class RaceOfOthersTest(unittest.TestCase):
    def launch(self, name):
        paths = f"{FIXTURE}:{os.environ['ROS_PACKAGE_PATH']}"
        launch = subprocess.Popen(
            ["roslaunch", "others_race", name],
            env={**os.environ, "ROS_PACKAGE_PATH": paths},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self.said = []
        listener = threading.Thread(target=lambda: self.said.extend(launch.stdout))
        listener.start()
        self.addCleanup(listener.join)
        self.addCleanup(launch.wait, LONG)
        self.addCleanup(launch.send_signal, signal.SIGINT)
        return launch

    def end(self, launch):
        """End it as a person would, and return what it has said."""
        launch.send_signal(signal.SIGINT)
        launch.wait(LONG)
        return "".join(self.said)

    def test_three_cars_of_one_description_drive(self):
        ways = Ways()
        launch = self.launch("race.launch")
        ways.wait_for(CARS, WAY)
        for car in CARS:
            rospy.wait_for_message(f"/{car}/bumper", ContactsState, LONG)
            topics = {topic for topic, _ in rospy.get_published_topics(f"/{car}")}
            assert f"/{car}/odom" not in topics
        said = self.end(launch)
        for noise in ("Controllers were left behind", "closed topic", "Traceback"):
            assert noise not in said, said

    def test_profile_sets_the_pace(self):
        self.launch("race.launch")
        rospy.wait_for_message("/clock", Clock, LONG)
        assert rospy.get_param("/gazebo/sim2d/real_time_factor") == 2.0

    def test_car_that_puts_itself_back_drives_again_and_again(self):
        launch = self.launch("learn.launch")
        count = threading.Event()
        rospy.Subscriber("/episodes", Int32, lambda message: message.data >= 20 and count.set())
        assert count.wait(LONG)
        assert "Traceback" not in self.end(launch)


if __name__ == "__main__":
    rospy.init_node("race_of_others_test", disable_rostime=True)
    rostest.rosrun("gazebo_ros", "race_of_others", RaceOfOthersTest)
