#!/usr/bin/env python3
"""The node race_mgr, seen from outside."""

import sys
from contextlib import ExitStack

import pytest
import rospy
from actionlib_msgs.msg import GoalStatus
from f1tenth_race_mgr.race import State
from geometry_msgs.msg import PoseArray
from std_srvs.srv import Trigger
from support import (
    LIMIT,
    MOCK,
    QUIET,
    RACE_MGR,
    Node,
    StartSignal,
    listen_to_results,
    listen_to_status,
    read_status,
)

from f1tenth_race_mgr.msg import RaceStatus

# The y of a goal is an order to the mock: see mock_move_base.py.
REACHED, ABORTED, DIES, DRIVES_ON = "1 0 0\n", "1 1 0\n", "1 5 0\n", "1 10 0\n"
NODE = "/robot1/race_mgr"


@pytest.fixture
def planner():
    with Node(MOCK) as node:
        yield node


@pytest.fixture
def start(tmp_path):
    """Return a function that starts the node on goals, with parameters."""
    with ExitStack() as nodes:

        def start_node(goals, **parameters):
            path = tmp_path / "goals.txt"
            path.write_text(goals)
            given = {"use_absolute_fpath": True, "fpath": str(path), "wait_for_start": False}
            rospy.set_param(NODE, {**given, **parameters})
            return nodes.enter_context(Node(RACE_MGR))

        yield start_node
    rospy.delete_param(NODE)


def test_the_states_are_those_of_the_message():
    assert {state.name: int(state) for state in State} == {
        name: getattr(RaceStatus, name) for name in vars(RaceStatus) if name.isupper()
    }


def test_goals_are_published_for_those_who_look_on_in_the_frame_of_their_file(start, planner):
    start("frame_id: robot1/odom\n1 0 0\n2 0 3.1415926\n", wait_for_start=True)
    goals = rospy.wait_for_message("/robot1/race_goals", PoseArray, LIMIT)
    assert goals.header.frame_id == "robot1/odom"
    assert [(pose.position.x, pose.position.y) for pose in goals.poses] == [(1.0, 0.0), (2.0, 0.0)]
    assert [round(pose.orientation.z, 6) for pose in goals.poses] == [0.0, 1.0]


def test_waits_for_the_start_then_drives_to_every_goal_and_stays(start, planner):
    with listen_to_status() as status, StartSignal() as starter:
        node = start(REACHED * 2, wait_for_start=True)
        assert status.wait_for((State.WAITING, 0))
        starter.publish(1)
        assert not status.wait_for((State.RACING, 0), QUIET)
        starter.publish(0)
        assert status.wait_for((State.FINISHED, 2))
        states = [State.WAITING, State.RACING, State.RACING, State.RACING, State.FINISHED]
        assert status.heard == list(zip(states, [0, 0, 1, 2, 2]))
    latched = read_status()
    assert (latched.state, latched.goals_total, latched.laps) == (State.FINISHED, 2, 1)
    assert latched.header.stamp > rospy.Time(0)
    node.interrupt()
    assert node.finish()[0] == 0


def test_says_what_the_planner_said_when_it_gave_up(start, planner):
    node = start(REACHED + ABORTED + REACHED)
    with listen_to_status() as status:
        assert status.wait_for((State.ABORTED, 1))
    text = "goal 2 of 3 aborted: Failed to find a valid plan. Even after executing recovery behaviors."
    assert read_status().text == text
    assert node.is_alive()
    node.interrupt()
    assert node.finish()[0] == 3


def test_ends_with_the_race_when_told_to(start, planner):
    assert start(REACHED, exit_when_done=True).finish()[0] == 0


def test_says_that_the_planner_is_lost_when_it_dies(start, planner):
    assert start(DIES, exit_when_done=True).finish()[0] == 4


def test_the_stop_service_cancels_the_goal_and_leaves_the_status(start, planner):
    with listen_to_status() as status, listen_to_results() as results:
        node = start(DRIVES_ON)
        assert status.wait_for((State.RACING, 0))
        rospy.wait_for_service(f"{NODE}/stop", LIMIT)
        assert rospy.ServiceProxy(f"{NODE}/stop", Trigger)().success
        assert status.wait_for((State.STOPPED, 0))
        assert node.is_alive()
        node.interrupt()
        assert node.finish()[0] == 0
        assert set(results.heard) <= {GoalStatus.PREEMPTED}


def test_an_interrupt_stops_the_car_before_the_node_ends(start, planner):
    with listen_to_status() as status, listen_to_results() as results:
        node = start(REACHED + DRIVES_ON)
        assert status.wait_for((State.RACING, 1))
        assert results.wait_for(GoalStatus.SUCCEEDED)
        node.interrupt()
        assert node.finish()[0] == 0
        assert status.wait_for((State.STOPPED, 1))
        assert results.wait_for(GoalStatus.PREEMPTED)


def test_an_interrupt_ends_it_while_it_waits(start):
    with listen_to_status() as status:
        node = start(REACHED, wait_for_start=True)
        assert status.wait_for((State.WAITING, 0))
        node.interrupt()
        assert node.finish()[0] == 0
        assert status.wait_for((State.STOPPED, 0))


def test_loop_mode_never_finishes_and_counts_laps(start, planner):
    with listen_to_status() as status:
        start(REACHED * 2, loop_mode=True)
        assert status.wait_for((State.RACING, 5))
    assert read_status().laps >= 2


def test_wrong_input_is_one_line_and_code_2(start):
    code, errors = start(REACHED + "1 2\n").finish()
    assert code == 2
    assert "goals.txt:2: " in errors
    # rospy itself may warn of those who were just connecting to a node that ends at once.
    assert len([line for line in errors.splitlines() if "[WARN]" not in line]) == 1, errors


if __name__ == "__main__":
    rospy.init_node("race_mgr_test")
    junit = [a.replace("--gtest_output=xml:", "--junitxml=") for a in sys.argv if "_output=xml:" in a]
    sys.exit(pytest.main([__file__, *junit]))
