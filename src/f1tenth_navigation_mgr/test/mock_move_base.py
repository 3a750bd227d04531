#!/usr/bin/env python3
"""A move_base action server that does what the y of a goal asks for.

Written on the action's topics, without actionlib, because it has to break actionlib's rules. Wall time only.
"""

import os
import signal
import sys
import threading
import warnings
from collections import Counter

import rospy
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from move_base_msgs.msg import MoveBaseActionFeedback, MoveBaseActionGoal, MoveBaseActionResult
from nav_msgs.msg import Path
from rospy.impl.masterslave import ROSHandler
from rospy.impl.registration import RegManager

SUCCEED, ABORT, REJECT, DROP, DELAY, DIE, LOSE_RESULT, HANG, FORGET, IGNORE, DRIVE, ACCEPT_LATE = range(12)
# These end by saying which goals follow: as soon as that is known, only if one does, only if none does.
TELL, TELL_NEXT, TELL_LAST = range(12, 15)

STATUS_PERIOD = 0.05  # s
DELAY_TIME = 1.5  # s, more than a client waits before it sends a goal again that was not taken
ACCEPT_TIME = 0.5  # s, less than a client waits before it sends the goal again
ABORT_TEXT = "Failed to find a valid plan. Even after executing recovery behaviors."


def publisher(topic, message_type, latch=False):
    # Synchronous, so that a result is on its way before the status that follows it; rospy warns of that.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SyntaxWarning)
        return rospy.Publisher(f"move_base/{topic}", message_type, latch=latch, queue_size=None)


def miss_first_publisher(topic):
    """Lose the first publisher of a topic, as rospy does that is told of it while it subscribes."""
    update, missed = RegManager.publisher_update, []

    def lossy_update(manager, name, uris):
        if name == rospy.resolve_name(topic) and uris and not missed:
            missed.extend(uris)
        else:
            update(manager, name, uris)

    RegManager.publisher_update = lossy_update


def refuse_first_subscriber(topic):
    """Answer the first who asks for a topic that it is not published."""
    answer, refused = ROSHandler.requestTopic, []

    def refuse_once(handler, caller, name, protocols):
        if name == rospy.resolve_name(topic) and not refused:
            refused.append(caller)
            return -1, f"not a publisher of {name}", []
        return answer(handler, caller, name, protocols)

    ROSHandler.requestTopic = refuse_once


class MockMoveBase:
    def __init__(self):
        self._lock = threading.RLock()
        self._goals = {}
        self._copies = Counter()
        self._silent = False
        self._telling = None  # goal id, behaviour and target of the goal that waits for what follows it
        self._ahead = []
        self._status = publisher("status", GoalStatusArray, latch=True)
        self._result = publisher("result", MoveBaseActionResult)
        self._feedback = publisher("feedback", MoveBaseActionFeedback)
        self._subscribers = [
            rospy.Subscriber("move_base/goal", MoveBaseActionGoal, self._on_goal),
            rospy.Subscriber("move_base/cancel", GoalID, self._on_cancel),
            rospy.Subscriber("move_base/goals_ahead", Path, self._on_goals_ahead),
        ]

    def run(self):
        stopped = threading.Event()
        rospy.on_shutdown(stopped.set)
        while not stopped.wait(STATUS_PERIOD):
            self._publish_status()

    def _on_goal(self, message):
        goal_id = message.goal_id
        behaviour = round(message.goal.target_pose.pose.position.y)
        with self._lock:
            self._copies[goal_id.id] += 1
            dropped = behaviour == DROP and self._copies[goal_id.id] == 1
            if goal_id.id in self._goals or behaviour == IGNORE or dropped:
                return
            if behaviour == ACCEPT_LATE:
                threading.Timer(ACCEPT_TIME, self._set, (goal_id, GoalStatus.ACTIVE)).start()
                return
            self._set(goal_id, GoalStatus.ACTIVE)
            self._behave(behaviour, goal_id)
            if behaviour in (TELL, TELL_NEXT, TELL_LAST):
                self._telling = (goal_id, behaviour, message.goal.target_pose)
                self._tell()

    def _on_goals_ahead(self, message):
        with self._lock:
            self._ahead = message.poses
            self._tell()

    def _tell(self):
        if not (self._telling and self._ahead):
            return
        goal_id, behaviour, target = self._telling
        first, *rest = self._ahead
        known = (first.header.stamp, first.pose) == (target.header.stamp, target.pose)
        if known and (behaviour == TELL or bool(rest) == (behaviour == TELL_NEXT)):
            self._telling = None
            numbers = " ".join(f"{goal.pose.position.x:g}" for goal in rest)
            self._end(goal_id, GoalStatus.SUCCEEDED, f"followed by {numbers}" if rest else "the last one")

    def _behave(self, behaviour, goal_id):
        if behaviour in (SUCCEED, DROP):
            self._reach(goal_id)
        elif behaviour == ABORT:
            self._end(goal_id, GoalStatus.ABORTED, ABORT_TEXT)
        elif behaviour == REJECT:
            self._end(goal_id, GoalStatus.REJECTED, "not that one")
        elif behaviour == DELAY:
            threading.Timer(DELAY_TIME, self._reach, (goal_id,)).start()
        elif behaviour == DIE:
            os.kill(os.getpid(), signal.SIGKILL)
        elif behaviour == LOSE_RESULT:
            self._set(goal_id, GoalStatus.SUCCEEDED, "Goal reached.")
        elif behaviour == HANG:
            self._silent = True
        elif behaviour == FORGET:
            del self._goals[goal_id.id]
            self._publish_status()

    def _reach(self, goal_id):
        copies = self._copies[goal_id.id]
        text = "Goal reached." if copies == 1 else f"Goal reached, sent {copies} times."
        self._end(goal_id, GoalStatus.SUCCEEDED, text)

    def _on_cancel(self, goal_id):
        with self._lock:
            self._silent = False
            known = self._goals.get(goal_id.id)
            if known and known.status == GoalStatus.ACTIVE:
                self._end(known.goal_id, GoalStatus.PREEMPTED, "cancelled")

    def _set(self, goal_id, status, text=""):
        with self._lock:
            self._goals[goal_id.id] = GoalStatus(goal_id=goal_id, status=status, text=text)
            self._publish_status()

    def _end(self, goal_id, status, text):
        with self._lock:
            result = MoveBaseActionResult(status=GoalStatus(goal_id=goal_id, status=status, text=text))
            self._result.publish(result)
            self._set(goal_id, status, text)

    def _publish_status(self):
        with self._lock:
            if not self._silent:
                self._status.publish(GoalStatusArray(status_list=list(self._goals.values())))


if __name__ == "__main__":
    rospy.init_node("move_base")
    if "miss_first" in sys.argv:
        miss_first_publisher("move_base/goal")
    if "refuse_first" in sys.argv:
        refuse_first_subscriber("move_base/status")
    MockMoveBase().run()
