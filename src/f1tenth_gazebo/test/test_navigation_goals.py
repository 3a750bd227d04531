"""A person clicks goals on the map in the real rviz; afterwards they are in the file."""

import contextlib
import importlib.util
import math
import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest
from f1tenth_gazebo.goals.goal_collector import goal_of
from f1tenth_navigation.goal_markers import goal_markers
from geometry_msgs.msg import PoseStamped
from PIL import Image
from test_create_map import free_port

from f1tenth_navigation_mgr import load_goals_file

# The screen belongs to the tests of f1tenth_navigation.
_SCREEN = Path(__file__).parents[2] / "f1tenth_navigation" / "test" / "screen.py"
_SPEC = importlib.util.spec_from_file_location("screen", _SCREEN)
screen = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(screen)

MISSING = [name for name in ("roslaunch", *screen.PROGRAMS) if shutil.which(name) is None]
PATIENCE = 120  # s of wall time
# Where navigation_goals.rviz shows the map.
CENTRE, CENTRE_PIXEL, PIXELS_PER_METRE = (1.0, 2.5), (874, 466), 55
ARROW, MAP = (217, 26, 153), (199, 201, 202)


def pixel(x, y):
    return (
        round(CENTRE_PIXEL[0] + (x - CENTRE[0]) * PIXELS_PER_METRE),
        round(CENTRE_PIXEL[1] - (y - CENTRE[1]) * PIXELS_PER_METRE),
    )


def wait_until(condition, what):
    end = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < end, f"not within {PATIENCE} s: {what}"
        time.sleep(0.1)


def sees(display, picture, wanted):
    """Whether a colour is in the picture; light and blending change it a little."""
    display.save_picture(picture)
    with Image.open(picture) as image:
        colours = image.convert("RGB").getcolors(1 << 24)
    return any(all(abs(a - b) <= 12 for a, b in zip(wanted, colour)) for _, colour in colours)


@contextlib.contextmanager
def launched(display, goals_file):
    port = str(free_port())
    command = ["roslaunch", "-p", port, "f1tenth_gazebo", "create_navigation_goals.launch"]
    environment = {**os.environ, **display.environment, "ROS_MASTER_URI": f"http://localhost:{port}"}
    process = subprocess.Popen([*command, f"goals_file:={goals_file}"], env=environment)
    try:
        yield
    finally:
        process.send_signal(signal.SIGINT)  # Ctrl-C
        process.wait()


def click(display, x, y, yaw, path, count):
    """Click until it has been taken: rviz may not listen to the keyboard yet."""
    display.press_key("g")
    display.drag(pixel(x, y), pixel(x + math.cos(yaw), y + math.sin(yaw)))
    wait_until(
        lambda: path.exists() and len(load_goals_file(str(path))) == count, f"{count} goals in the file"
    )


@pytest.mark.skipif(bool(MISSING), reason=f"not there: {', '.join(MISSING)}")
def test_clicked_goals_are_in_the_file_after_ctrl_c(tmp_path):
    path = tmp_path / "goals.txt"
    picture = os.path.join(os.environ.get("F1TENTH_PICTURES", str(tmp_path)), "navigation_goals.png")
    with contextlib.closing(screen.Screen()) as display, launched(display, path):
        display.focus("RViz")
        wait_until(lambda: sees(display, picture, MAP), "the map is in the picture")
        click(display, 3.0, 0.0, 0.0, path, 1)
        click(display, 6.5, 2.5, math.pi / 2.0, path, 2)
        wait_until(lambda: sees(display, picture, ARROW), "arrows are in the picture")
    goals = load_goals_file(str(path))
    assert [(goal.x, goal.y, goal.yaw) for goal in goals] == [
        pytest.approx((3.0, 0.0, 0.0), abs=0.05),
        pytest.approx((6.5, 2.5, math.pi / 2.0), abs=0.05),
    ]


def pose(x, y, yaw):
    message = PoseStamped()
    message.header.frame_id = "map"
    message.pose.position.x, message.pose.position.y = x, y
    message.pose.orientation.z, message.pose.orientation.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)
    return message


def test_goal_has_the_pose_that_was_clicked():
    goal = goal_of(pose(1.0, 2.0, -3.0))
    assert (goal.x, goal.y, goal.yaw, goal.frame_id) == (1.0, 2.0, pytest.approx(-3.0), "map")


def test_markers_are_numbered_from_one():
    markers = goal_markers([pose(1.0, 2.0, 0.0), pose(3.0, 2.0, 1.0)]).markers
    assert [marker.text for marker in markers if marker.ns == "numbers"] == ["1", "2"]
    assert [marker.pose.position.x for marker in markers if marker.ns == "arrows"] == [1.0, 3.0]
    assert len({(marker.ns, marker.id) for marker in markers if marker.action == marker.ADD}) == 4
