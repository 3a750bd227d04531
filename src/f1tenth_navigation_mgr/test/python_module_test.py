#!/usr/bin/env python3
"""What only the Python module has: names, threads, exceptions, life beside rospy."""

import subprocess
import sys
import tempfile
import threading
import time

import pytest
import rosnode
import rospy
from drive import LIMIT, Server
from std_msgs.msg import Int32

import f1tenth_navigation_mgr as nav


def wait_until(condition):
    end = time.monotonic() + LIMIT
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.01)
    return True


@pytest.fixture(scope="module", autouse=True)
def server():
    with Server("robot1"):
        yield


@pytest.fixture
def navigation():
    return nav.NavigationMgr("robot1")


def spin_until(navigation, *results):
    while True:
        did = navigation.spin()
        if did in results:
            return did


def test_goals_are_values():
    goal = nav.Goal(1.0, 2.0, 0.5)
    assert goal == nav.Goal(1.0, 2.0, 0.5, "map")
    assert repr(goal) == "Goal(x=1.0, y=2.0, yaw=0.5, frame_id='map')"


def test_a_wrong_file_raises_goals_file_error_and_loads_nothing(navigation):
    with tempfile.NamedTemporaryFile("w") as file:
        file.write("1 2 3\n1 2\n")
        file.flush()
        with pytest.raises(nav.GoalsFileError, match=rf"^{file.name}:2: "):
            navigation.load_goals(file.name)
    assert navigation.goals_left == 0
    assert issubclass(nav.GoalsFileError, nav.NavigationError)


def test_knows_map_and_the_odometry_frame_of_its_car(navigation):
    with tempfile.NamedTemporaryFile("w") as file:
        file.write("frame_id: mars\n1 2 3\n")
        file.flush()
        with pytest.raises(nav.GoalsFileError, match="expected one of: map, robot1/odom$"):
            navigation.load_goals(file.name)


def test_tells_goal_in_flight_and_goals_left(navigation):
    navigation.add_goal(nav.Goal(1.0, 4.0, 0.0))
    navigation.add_goal(nav.Goal(2.0, 0.0, 0.0))
    assert navigation.goal_in_flight is None
    spin_until(navigation, nav.SpinResult.SENT)
    assert navigation.goal_in_flight == nav.Goal(1.0, 4.0, 0.0)
    assert navigation.goals_left == 2
    assert navigation.queue == [nav.Goal(1.0, 4.0, 0.0), nav.Goal(2.0, 0.0, 0.0)]
    spin_until(navigation, nav.SpinResult.REACHED)
    assert navigation.goals_left == 1


def test_the_parts_of_a_spin_refuse_what_makes_no_sense(navigation):
    with pytest.raises(nav.NavigationError, match="^there is no goal in the queue$"):
        navigation.front_goals_queue()
    assert navigation.check_goal_state() == nav.SpinResult.IDLE
    navigation.add_goal(nav.Goal(2.0, 0.0, 0.0))
    assert navigation.wait_for_server(LIMIT)
    assert navigation.send_goal(nav.Goal(1.0, 4.0, 0.0)) == nav.SpinResult.SENT
    assert navigation.has_active_goal()
    assert navigation.front_goals_queue() == nav.Goal(1.0, 4.0, 0.0)
    assert navigation.size_goals_queue() == 2
    with pytest.raises(nav.NavigationError, match="^a goal is active"):
        navigation.send_goal(nav.Goal(3.0, 0.0, 0.0))


def test_a_result_has_its_times(navigation):
    navigation.add_goal(nav.Goal(1.0, 4.0, 0.0))
    spin_until(navigation, nav.SpinResult.REACHED)
    (result,) = navigation.results
    assert result.outcome == nav.GoalOutcome.SUCCEEDED
    assert isinstance(result.sent, rospy.Time)
    assert (result.ended - result.sent).to_sec() > 0.4


def test_spin_at_a_given_time_stamps_with_it(navigation):
    navigation.add_goal(nav.Goal(1.0, 0.0, 0.0))
    assert navigation.wait_for_server(LIMIT)
    now = rospy.Time(1234, 5)
    assert navigation.spin(now) == nav.SpinResult.SENT
    assert wait_until(lambda: navigation.spin(now) == nav.SpinResult.REACHED)
    assert navigation.results[0].sent == now
    assert navigation.results[0].ended == now


def test_what_a_callback_raises_comes_out_of_spin(navigation):
    def fail(_result):
        raise KeyError("mine")

    navigation.on_goal_reached(fail)
    navigation.add_goal(nav.Goal(1.0, 0.0, 0.0))
    with pytest.raises(KeyError, match="mine"):
        spin_until(navigation, nav.SpinResult.REACHED)
    assert spin_until(navigation, nav.SpinResult.QUEUE_EMPTY) == nav.SpinResult.QUEUE_EMPTY


def test_waiting_lets_other_python_threads_run():
    waiting = threading.Thread(target=nav.NavigationMgr("nobody").wait_for_server, args=(0.2,))
    waiting.start()
    turns = 0
    while waiting.is_alive():
        turns += 1
    assert turns > 100


def test_remappings_of_the_command_line_hold():
    assert nav.NavigationMgr("alias").action_name == "/robot1/move_base"


def test_the_namespace_of_the_node_holds():
    assert nav.NavigationMgr("").action_name == "/move_base"
    command = [
        sys.executable,
        "-c",
        "import f1tenth_navigation_mgr as n; print(n.NavigationMgr('').action_name)",
    ]
    output = subprocess.run(command + ["__ns:=/robot7"], capture_output=True, text=True, timeout=LIMIT)
    assert output.stdout == "/robot7/move_base\n"


def test_a_missing_master_is_one_line():
    program = (
        "import f1tenth_navigation_mgr as n\ntry: n.StartSignal()\nexcept n.NavigationError as e: print(e)"
    )
    command = [sys.executable, "-c", program, "__master:=http://localhost:1"]
    output = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
    assert output.stdout == "no ROS master at http://localhost:1\n"


def test_the_start_signal_reaches_late_listeners_and_stays():
    publisher = rospy.Publisher("/time_to_start", Int32, latch=True, queue_size=10)
    publisher.publish(2)
    signal = nav.StartSignal()
    assert wait_until(lambda: signal.seconds_left() == 2)
    assert not signal.has_started()
    publisher.publish(0)
    assert wait_until(signal.has_started)
    publisher.publish(5)
    assert wait_until(lambda: signal.seconds_left() == 5)
    assert signal.has_started()


def test_only_the_starter_starts():
    publisher = rospy.Publisher("/time_to_start", Int32, latch=True, queue_size=10)
    publisher.publish(0)
    others, own = nav.StartSignal(starter="/race_starter"), nav.StartSignal(starter=rospy.get_name())
    # Both hear it over one connection.
    assert wait_until(own.has_started)
    assert (others.has_started(), others.seconds_left()) == (False, None)


def test_the_second_half_is_called_like_the_node():
    nav.StartSignal()
    assert wait_until(lambda: f"{rospy.get_name()}_roscpp" in rosnode.get_node_names())


if __name__ == "__main__":
    rospy.init_node("python_module_test")
    junit = [a.replace("--gtest_output=xml:", "--junitxml=") for a in sys.argv if "_output=xml:" in a]
    sys.exit(pytest.main([__file__, *junit]))
