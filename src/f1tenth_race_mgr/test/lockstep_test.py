#!/usr/bin/env python3
"""race_mgr as a participant; this test plays simulator, starter and the planner's answers."""

import sys

import pytest
import rospy
from f1tenth_race_mgr.race import State
from support import MOCK, QUIET, RACE_MGR, Lockstep, Node, StartSignal, listen_to_status, read_status

PERIOD = 25_000_000  # ns
STARTER = "race_starter"
BOTH = [STARTER, "robot1/move_base"]
NODE = "/robot1/race_mgr"


@pytest.fixture
def goals(tmp_path):
    path = tmp_path / "goals.txt"
    path.write_text("1 10 0\n")
    rospy.set_param(NODE, {"use_absolute_fpath": True, "fpath": str(path), "lockstep": True})
    yield
    rospy.delete_param(NODE)


@pytest.fixture
def lockstep(goals):
    with Lockstep() as simulator:
        yield simulator


def test_is_ready_only_with_planner_and_starter(lockstep):
    with StartSignal() as starter, Node(RACE_MGR), listen_to_status() as status:
        assert not lockstep.run_period(PERIOD, BOTH, QUIET)
        assert status.wait_for((State.WAITING, 0))
        with Node(MOCK):
            assert not lockstep.run_period(PERIOD, BOTH, QUIET)
            starter.publish(5)
            assert lockstep.run_period(PERIOD, BOTH)


def test_acts_in_the_period_of_the_start_and_not_before_planner_and_starter(lockstep):
    with StartSignal() as starter, Node(MOCK), Node(RACE_MGR), listen_to_status() as status:
        starter.publish(1)
        assert lockstep.run_period(PERIOD, BOTH)
        starter.publish(0)
        assert not lockstep.run_period(2 * PERIOD, [STARTER], QUIET)
        assert (State.RACING, 0) not in status.heard
        assert lockstep.run_period(2 * PERIOD, BOTH)
        assert status.wait_for((State.RACING, 0))
        assert read_status().header.stamp.to_nsec() == 2 * PERIOD


def test_leaves_when_it_is_stopped(lockstep):
    with StartSignal() as starter, Node(MOCK), Node(RACE_MGR) as node:
        starter.publish(0)
        assert lockstep.run_period(PERIOD, BOTH)
        node.interrupt()
        assert lockstep.has_left()
        assert node.finish()[0] == 0


def test_notices_a_dead_planner_while_the_clock_stands(lockstep):
    with StartSignal() as starter, Node(MOCK) as planner, Node(RACE_MGR), listen_to_status() as status:
        starter.publish(0)
        assert lockstep.run_period(PERIOD, BOTH)
        planner.kill()
        assert status.wait_for((State.LOST, 0))
        assert lockstep.has_left()


if __name__ == "__main__":
    rospy.init_node("lockstep_test")
    junit = [a.replace("--gtest_output=xml:", "--junitxml=") for a in sys.argv if "_output=xml:" in a]
    sys.exit(pytest.main([__file__, *junit]))
