#!/usr/bin/env python3
"""Waits for the simulated time as roscpp does: `rate` sleeps for a millisecond, `timer` waits as long."""

import threading
import time

import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from sensor_msgs.msg import LaserScan

PERIOD = 0.025  # s
POLL = 0.001  # wall s


class Polling:
    def __init__(self, how):
        self.wait = {"rate": self.sleep, "timer": self.wait_for_signal}[how]
        self.signal = threading.Condition()
        self.scans = 0
        self.publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=1)
        rospy.Subscriber("scan", LaserScan, self.on_scan, queue_size=1)

    def on_scan(self, _scan):
        self.scans += 1

    def sleep(self):
        time.sleep(POLL)

    def wait_for_signal(self):
        with self.signal:
            self.signal.wait(POLL)

    def run(self):
        due = rospy.get_time()
        while not rospy.is_shutdown():
            if rospy.get_time() < due:
                self.wait()
                continue
            due += PERIOD
            command = AckermannDriveStamped()
            command.drive.speed = 0.2 + 0.01 * self.scans
            self.publisher.publish(command)


if __name__ == "__main__":
    rospy.init_node("polling")
    Polling(rospy.get_param("~how")).run()
