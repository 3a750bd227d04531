#!/usr/bin/env python3
"""A planner that goes wrong in the way that its argument names."""

import sys
import threading
import time

import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from geometry_msgs.msg import Twist
from nav_msgs.msg import Path
from sensor_msgs.msg import LaserScan


def command(speed=1.0):
    message = AckermannDriveStamped()
    message.drive.speed = speed
    return message


def ends_at_once(_publisher):
    print("nothing to do")
    sys.exit(0)


def dies_at_once(_publisher):
    raise ValueError("no model weights in /models")


def raises_in_callback(_publisher):
    rospy.Subscriber("scan", LaserScan, lambda scan: scan.no_such_field, queue_size=1)
    rospy.spin()


def is_silent(_publisher):
    rospy.logwarn("waiting for a joystick")
    rospy.spin()


def hears_another_type(publisher):
    rospy.Subscriber("/map", Path, lambda _path: publisher.publish(command()), queue_size=1)
    rospy.spin()


def says_nan(publisher):
    rospy.Subscriber("scan", LaserScan, lambda _scan: publisher.publish(command(float("nan"))), queue_size=1)
    rospy.spin()


def floods(publisher):
    while not rospy.is_shutdown():
        publisher.publish(command())
        time.sleep(1e-4)


def goes_by_the_wall_clock(publisher):
    def send():
        while not rospy.is_shutdown():
            publisher.publish(command(0.5))
            time.sleep(0.02)

    threading.Thread(target=send, daemon=True).start()
    rospy.spin()


def hangs_in_callback(publisher):
    scans = []

    def answer(scan):
        scans.append(scan)
        while len(scans) > 60:
            pass
        publisher.publish(command(0.5))

    rospy.Subscriber("scan", LaserScan, answer, queue_size=1)
    rospy.spin()


def compiles_in_callback(publisher):
    """As numba does: only the first scan takes long."""
    compiled = []

    def answer(_scan):
        end = time.process_time() + 6.0
        while not compiled and time.process_time() < end:
            pass
        compiled.append(True)
        publisher.publish(command(0.5))

    rospy.Subscriber("scan", LaserScan, answer, queue_size=1)
    rospy.spin()


def sends_elsewhere(publisher):
    publisher.unregister()
    elsewhere = rospy.Publisher("/nav", AckermannDriveStamped, queue_size=1)
    rospy.Subscriber("/scan", LaserScan, lambda _scan: elsewhere.publish(command()), queue_size=1)
    rospy.spin()


def sends_twists(publisher):
    publisher.unregister()
    rospy.Publisher("drive", Twist, queue_size=1)
    rospy.spin()


def hears_everybody(publisher):
    shared = rospy.Publisher("/nav", AckermannDriveStamped, queue_size=1)
    rospy.Subscriber("scan", LaserScan, lambda _scan: shared.publish(command(0.5)), queue_size=1)
    rospy.Subscriber("/nav", AckermannDriveStamped, publisher.publish, queue_size=1)
    rospy.spin()


if __name__ == "__main__":
    rospy.init_node("misbehaving")
    globals()[rospy.get_param("~how")](rospy.Publisher("drive", AckermannDriveStamped, queue_size=1))
