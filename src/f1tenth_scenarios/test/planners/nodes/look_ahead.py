#!/usr/bin/env python3
"""The first of two nodes: from the odometry, publishes the point of the line that is to be driven to."""

import numpy as np
import rospy
from geometry_msgs.msg import PointStamped
from nav_msgs.msg import Odometry

LOOK_AHEAD = 1.2  # m


class LookAhead:
    def __init__(self):
        self.line = np.genfromtxt(
            rospy.get_param("~line"), delimiter=rospy.get_param("~delimiter"), comments="#"
        )
        columns = (1, 2) if self.line.shape[1] > 4 else (0, 1)  # a raceline, or a centreline
        self.line = self.line[:, columns]
        self.publisher = rospy.Publisher("target", PointStamped, queue_size=1)
        rospy.Subscriber("perfect_odom", Odometry, self.on_odometry, queue_size=1)

    def on_odometry(self, odometry):
        place = odometry.pose.pose.position
        distances = np.hypot(self.line[:, 0] - place.x, self.line[:, 1] - place.y)
        number = int(np.argmin(distances))
        while distances[number % len(distances)] < LOOK_AHEAD:
            number += 1
        message = PointStamped(header=odometry.header)
        message.point.x, message.point.y = self.line[number % len(distances)]
        self.publisher.publish(message)


if __name__ == "__main__":
    rospy.init_node("look_ahead")
    LookAhead()
    rospy.spin()
