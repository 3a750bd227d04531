"""The node race_markers: goals with their numbers and contacts of a car, for rviz."""

import rospy
from actionlib_msgs.msg import GoalStatus
from diagnostic_msgs.msg import DiagnosticArray
from gazebo_msgs.msg import ContactsState
from geometry_msgs.msg import PoseArray
from move_base_msgs.msg import MoveBaseActionGoal, MoveBaseActionResult
from visualization_msgs.msg import MarkerArray

from f1tenth_navigation.contact_markers import ContactPlaces
from f1tenth_navigation.goal_markers import goal_markers, trouble_marker
from f1tenth_navigation.known_goals import KnownGoals

BUMPERS = ("bumper_front", "bumper_rear", "bumper_left", "bumper_right")
# Contact sensors give world coordinates, whatever frame their header names.
WORLD = "map"
# Stamps of the sensors may be this much out of order; time that goes back further is that of a new run.
_DISORDER = 1.0  # s


class RaceMarkers:
    """Connects goals and contacts to their markers. rospy calls back from a thread for each connection."""

    def __init__(self):
        """Advertise and subscribe in the namespace of the car."""
        self._goals, self._contacts = KnownGoals(), ContactPlaces()
        self._stamp = 0.0
        self._trouble = None
        self._driving = rospy.resolve_name("move_base")[1:] + ": driving"
        self._goal_publisher = rospy.Publisher("goal_markers", MarkerArray, queue_size=1, latch=True)
        self._contact_publisher = rospy.Publisher("contact_markers", MarkerArray, queue_size=1, latch=True)
        rospy.Subscriber("race_goals", PoseArray, self._on_race)
        rospy.Subscriber("move_base/goal", MoveBaseActionGoal, self._on_goal)
        rospy.Subscriber("move_base/result", MoveBaseActionResult, self._on_result)
        rospy.Subscriber("/diagnostics", DiagnosticArray, self._on_diagnostics)
        for topic in BUMPERS:
            rospy.Subscriber(topic, ContactsState, self._on_contacts)

    def _on_race(self, goals):
        self._goals.take_race(goals)
        self._publish_goals()

    def _on_goal(self, goal):
        if self._goals.take_sent(goal.goal.target_pose, goal.goal_id.id):
            self._publish_goals()

    def _on_result(self, result):
        status = result.status
        failed = status.status in (GoalStatus.ABORTED, GoalStatus.REJECTED)
        if failed and self._goals.take_failure(status.goal_id.id, status.text or "given up"):
            self._publish_goals()

    def _on_diagnostics(self, diagnostics):
        for status in diagnostics.status:
            trouble = trouble_marker(status) if status.name == self._driving else self._trouble
            if trouble != self._trouble:
                self._trouble = trouble
                self._publish_goals()

    def _publish_goals(self):
        message = goal_markers(self._goals.poses, self._goals.problems)
        if self._trouble:
            message.markers.append(self._trouble)
        self._goal_publisher.publish(message)

    def _on_contacts(self, contacts):
        stamp = contacts.header.stamp.to_sec()
        if stamp < self._stamp - _DISORDER:
            self._contacts = ContactPlaces()
            self._contact_publisher.publish(self._contacts.markers(WORLD))
        self._stamp = stamp
        if contacts.states and self._contacts.take(contacts):
            self._contact_publisher.publish(self._contacts.markers(WORLD))


def main():
    """Run the node."""
    rospy.init_node("race_markers")
    RaceMarkers()
    rospy.spin()
