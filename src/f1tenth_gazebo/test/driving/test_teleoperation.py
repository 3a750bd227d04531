"""Keys and axes must become commands."""

import pytest
from f1tenth_gazebo.driving.teleoperation import SPEED_MAX, STEERING_MAX, Command, keys_in


def test_arrow_keys_are_read_in_both_modes_of_a_terminal():
    assert keys_in(b"\x1b[A\x1b[B\x1b[C\x1b[D") == ["up", "down", "right", "left"]
    assert keys_in(b"\x1bOA\x1bOD") == ["up", "left"]


def test_other_keys_are_left_out():
    assert keys_in(b"x\x1b[A~ q") == ["up", "stop", "quit"]


def test_up_and_down_change_the_speed():
    command = Command()
    command.press("up")
    command.press("up")
    command.press("down")
    assert command == Command(0.25, 0.0)


def test_left_is_positive_and_space_stops():
    command = Command(speed=1.0)
    command.press("left")
    assert command.steering == pytest.approx(0.05)
    command.press("stop")
    assert command == Command()


@pytest.mark.parametrize(("key", "end"), [("up", SPEED_MAX), ("down", -SPEED_MAX)])
def test_speed_has_limits(key, end):
    command = Command()
    for _ in range(100):
        command.press(key)
    assert command.speed == end


def test_sticks_are_axes():
    command = Command()
    command.push([0.0, 0.5, 0.0, -2.0])
    assert (command.speed, command.steering) == (0.5 * SPEED_MAX, -STEERING_MAX)
    command.push([0.0])
    assert command == Command()
