#!/usr/bin/env python3
"""Faults happen in exactly their control period, under a real master with a real victim."""

import contextlib
import queue
import sys
import time
import unittest
from pathlib import Path

import pytest
import rospy
import rostest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.observations import RaceState, RaceUpdate
from f1tenth_judge.scenario.scenario import Box, Fault, Push, Verdict
from f1tenth_scenarios.run.events.director import Director
from f1tenth_scenarios.run.events.ros_node_kill import kill_node
from f1tenth_scenarios.run.ros_graph import ask
from f1tenth_scenarios.run.ros_watch import RosWatch
from gazebo_msgs.srv import GetModelState, GetModelStateResponse, SetModelState, SetModelStateResponse
from geometry_msgs.msg import Pose, PoseWithCovarianceStamped
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Header
from workspace_support.nodes import synchronous_publisher

from f1tenth_race_mgr.msg import RaceStatus

sys.path.insert(0, str(Path(__file__).parents[3] / "f1tenth_judge" / "test"))

from scenario_samples import sample_plan, scenario  # noqa: E402

PATIENCE = 20.0  # wall s
VICTIM = "robot1/move_base"


def plan(faults=(), lockstep=True, **others):
    wanted = scenario(Verdict.ERROR, lockstep=lockstep, faults=tuple(faults), **others)
    return sample_plan(Path("no_folder"), wanted)


@contextlib.contextmanager
def called(name):
    """Connections that this process accepts meanwhile are those of another node."""
    own = rospy.get_name()
    rospy.names._set_caller_id(name)
    try:
        yield
    finally:
        rospy.names._set_caller_id(own)


class DirectorTest(unittest.TestCase):
    def setUp(self):
        self._answers = queue.SimpleQueue()
        self._clock = rospy.Publisher("/clock", Clock, queue_size=10)
        self._done = rospy.Publisher("/sim2d/done", Header, queue_size=10)
        self._listener = rospy.Subscriber("/sim2d/done", Header, self._hear)
        self._directors = []

    def tearDown(self):
        for director in self._directors:
            director.close()
        self._listener.unregister()
        # The next test would take a connection that is just closing for that of its own director.
        self._wait_for(lambda: not self._clock.get_num_connections() and not self._done.get_num_connections())

    def test_every_period_is_answered_until_the_last_fault(self):
        self._direct(plan([Fault("robot1/nobody", 1.0)]))
        self._tick(0.025)
        assert self._answer() == 0.025
        self._tick(0.05)
        assert self._answer() == 0.05

    def test_victim_dies_after_it_has_answered_its_period_and_before_the_next(self):
        self._wait_for(self._victim_lives)
        self._direct(plan([Fault(VICTIM, 1.0)]))
        self._tick(0.975)
        assert self._answer() == 0.975
        self._tick(1.0)
        assert self._victim_lives()
        self._done.publish(Header(stamp=rospy.Time(1), frame_id=VICTIM))
        assert self._answer() == 2147483647.0
        assert not self._victim_lives()

    def test_fault_that_cannot_happen_is_reported(self):
        director = self._direct(plan([Fault("robot1/nobody", 1.0)], lockstep=False))
        self._tick(1.0)
        self._wait_for(lambda: director.failure)
        assert director.failure.culprit == "runner"
        assert "cannot find robot1/nobody: " in director.failure.reason

    def test_unknown_node_cannot_be_killed(self):
        with pytest.raises(ScenarioError, match="cannot find robot1/nobody: "):
            kill_node("robot1/nobody")

    def test_box_is_pushed_where_it_is(self):
        asked = queue.SimpleQueue()
        standing = GetModelStateResponse(pose=self._turned(), success=True)
        rospy.Service("/gazebo/get_model_state", GetModelState, lambda request: standing)
        rospy.Service(
            "/gazebo/set_model_state",
            SetModelState,
            lambda request: asked.put(request.model_state) or SetModelStateResponse(success=True),
        )
        push = Push(at=1.0, speed=2.0, direction=3.141592653589793)
        self._direct(plan(boxes=(Box("crate", 0.0, 0.0, movable=True, pushes=(push,)),)))
        self._tick(0.975)
        assert self._answer() == 0.975
        assert asked.empty()
        self._tick(1.0)
        assert self._answer() == 2147483647.0
        state = asked.get(timeout=PATIENCE)
        assert (state.model_name, state.pose) == ("crate", self._turned())
        assert (round(state.twist.linear.x, 9), round(state.twist.linear.y, 9)) == (-2.0, 0.0)

    def test_status_of_the_race_is_heard_in_order(self):
        publisher = rospy.Publisher("/robot1/race_status", RaceStatus, queue_size=10)
        watch = self._watch("/robot1/race_mgr", publisher)
        for state, reached in ((RaceStatus.RACING, 1), (RaceStatus.ABORTED, 1)):
            message = RaceStatus(state=state, goals_reached=reached, text="why")
            message.header.stamp = rospy.Time(2, 500000000)
            publisher.publish(message)
        heard = []
        self._wait_for(lambda: heard.extend(watch.take()) or len(heard) == 2)
        assert heard[0] == RaceUpdate("robot1", 2.5, RaceState.RACING, 1, "why")
        assert heard[1].state == RaceState.ABORTED
        assert watch.failure(done=set()) is None
        watch.close()

    def test_status_of_the_race_by_another_node_is_not_heard(self):
        publisher = synchronous_publisher("/robot1/race_status", RaceStatus)
        watch = self._watch("/robot2/race_mgr", publisher)
        publisher.publish(RaceStatus(state=RaceStatus.ABORTED))
        publisher.unregister()
        self._wait_for(lambda: not any(each.get_num_connections() for each in watch._subscribers))
        assert watch.take() == []
        watch.close()

    def test_estimates_are_heard_to_the_last(self):
        publisher = synchronous_publisher("/robot1/amcl_pose", PoseWithCovarianceStamped)
        watch = self._watch("/robot1/amcl", publisher)
        for index in range(3):
            message = PoseWithCovarianceStamped()
            message.header.stamp = rospy.Time(index + 1)
            message.pose.pose.position.x = 3.0
            message.pose.pose.orientation.z = message.pose.pose.orientation.w = 0.5**0.5
            publisher.publish(message)
        publisher.unregister()
        (estimates,) = watch.estimates().values()
        watch.close()
        assert estimates.stamps == [1.0, 2.0, 3.0]
        assert estimates.values == [(3.0, 0.0, 1.5708)] * 3

    def _watch(self, publishing_node, publisher):
        with called(publishing_node):
            watch = RosWatch(plan())
            self._wait_for(lambda: publisher.get_num_connections() > 0)
        return watch

    @staticmethod
    def _turned():
        pose = Pose()
        pose.position.x = 3.0
        pose.orientation.z = pose.orientation.w = 0.5**0.5
        return pose

    def _direct(self, wanted):
        self._directors.append(Director(wanted))
        # One connection serves all subscribers of a process.
        self._wait_for(lambda: self._clock.get_num_connections() and self._done.get_num_connections())
        return self._directors[-1]

    def _victim_lives(self):
        try:
            return ask(VICTIM, "getPid") > 0
        except ScenarioError:
            return False

    def _tick(self, seconds):
        self._clock.publish(Clock(rospy.Time.from_sec(seconds)))

    def _hear(self, message):
        if message.frame_id == "scenario":
            self._answers.put(message.stamp.to_sec())

    def _answer(self):
        return self._answers.get(timeout=PATIENCE)

    def _wait_for(self, condition):
        end = time.monotonic() + PATIENCE
        while not condition():
            assert time.monotonic() < end, "waited in vain"
            time.sleep(0.01)


if __name__ == "__main__":
    rospy.init_node("director_test")
    rostest.rosrun("f1tenth_scenarios", "director_test", DirectorTest, sys.argv)
