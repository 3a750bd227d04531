"""A person clicks goals on the map in the real rviz; afterwards they are in the file."""

import contextlib
import importlib.util
import io
import math
import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
import rosgraph
from f1tenth_gazebo.goals.goal_collector import goal_of, road_markers, stamped
from f1tenth_gazebo.goals.road_ahead import road_ahead
from f1tenth_judge.scenario.car import Pose
from f1tenth_navigation.goal_markers import goal_markers
from PIL import Image
from ports import free_port

from f1tenth_navigation_mgr import load_goals_file

# The screen belongs to the tests of f1tenth_navigation.
_SCREEN = Path(__file__).parents[3] / "f1tenth_navigation" / "test" / "screen.py"
_SPEC = importlib.util.spec_from_file_location("screen", _SCREEN)
screen = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(screen)

MISSING = [name for name in ("roslaunch", *screen.PROGRAMS) if shutil.which(name) is None]
PATIENCE = 120  # s of wall time
ATTEMPTS = 3
# Where navigation_goals.rviz shows the map.
CENTRE, CENTRE_PIXEL, PIXELS_PER_METRE = (1.0, 2.5), (874, 466), 55
ARROW, RED, MAP = (217, 26, 153), (217, 26, 26), (199, 201, 202)


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
def running(display, goals_file):
    port = str(free_port())
    command = ["roslaunch", "-p", port, "f1tenth_gazebo", "create_navigation_goals.launch"]
    environment = {**os.environ, **display.environment, "ROS_MASTER_URI": f"http://localhost:{port}"}
    process = subprocess.Popen([*command, f"goals_file:={goals_file}"], env=environment)
    try:
        yield process
    finally:
        process.send_signal(signal.SIGINT)  # Ctrl-C
        process.wait()


def starts(process, display, picture, wanted):
    """Whether rviz shows a colour and takes the keyboard before it dies."""

    def is_there():
        return sees(display, picture, wanted) and display.takes_keyboard("RViz")

    wait_until(lambda: process.poll() is not None or is_there(), "rviz is there, and the colour")
    return process.poll() is None


@contextlib.contextmanager
def launched(goals_file, picture, wanted):
    """A screen on which rviz shows a colour; now and then rviz dies of itself while it starts."""
    for _ in range(ATTEMPTS):
        with contextlib.closing(screen.Screen()) as display, running(display, goals_file) as process:
            if starts(process, display, picture, wanted):
                yield display
                return
    pytest.fail(f"rviz died {ATTEMPTS} times while it started")


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
    with launched(path, picture, MAP) as display:
        click(display, 3.0, 0.0, 0.0, path, 1)
        click(display, 7.5, 2.5, math.pi / 2.0, path, 2)
        click(display, 1.0, 4.0, 0.0, path, 3)
        wait_until(lambda: sees(display, picture, ARROW), "arrows are in the picture")
        wait_until(lambda: sees(display, picture, RED), "the goal in the wall is red")
        click(display, 3.0, 0.0, 0.0, path, 2)
    # Started again, clicks are appended to what is there.
    with launched(path, picture, ARROW) as display:
        click(display, -2.0, 5.0, 2.8, path, 3)
    goals = load_goals_file(str(path))
    assert [(goal.x, goal.y, goal.yaw) for goal in goals] == [
        pytest.approx((7.5, 2.5, math.pi / 2.0), abs=0.05),
        pytest.approx((1.0, 4.0, 0.0), abs=0.05),
        pytest.approx((-2.0, 5.0, 2.8), abs=0.05),
    ]


def test_goal_has_the_pose_that_was_clicked():
    goal = goal_of(stamped(1.0, 2.0, -3.0))
    assert (goal.x, goal.y, goal.yaw, goal.frame_id) == (1.0, 2.0, pytest.approx(-3.0), "map")


def test_markers_are_numbered_from_one():
    markers = goal_markers([stamped(1.0, 2.0, 0.0), stamped(3.0, 2.0, 1.0)]).markers
    assert [marker.text for marker in markers if marker.ns == "numbers"] == ["1", "2"]
    assert [marker.pose.position.x for marker in markers if marker.ns == "arrows"] == [1.0, 3.0]
    assert len({(marker.ns, marker.id) for marker in markers if marker.action == marker.ADD}) == 6


PACKAGE = Path(__file__).parents[2]


def test_road_of_a_circuit_begins_at_its_start_line():
    road = road_ahead(PACKAGE / "worlds" / "circuit1.world")
    assert (road[0].x, road[0].y, road[0].yaw) == (0.0, 0.0, 0.0)
    assert len(road) > 8
    assert max(pose.y for pose in road) == pytest.approx(5.0, abs=0.1)


@pytest.mark.parametrize("name", ["ring_map.yaml", "ring.world"])
def test_road_of_a_track_follows_its_centreline(tmp_path, name):
    angles = np.linspace(0.0, math.tau, 100, endpoint=False)
    rows = np.column_stack([5.0 * np.cos(angles), 5.0 * np.sin(angles), np.ones(100), np.ones(100)])
    np.savetxt(
        tmp_path / "ring_centerline.csv", rows, delimiter=",", header="x_m, y_m, w_tr_right_m, w_tr_left_m"
    )
    road = road_ahead(tmp_path / name)
    assert (road[0].x, road[0].y) == pytest.approx((5.0, 0.0))
    assert road[0].yaw == pytest.approx(math.pi / 2.0, abs=0.05)
    assert len(road) == 11


def test_road_is_shown_by_arrows_with_the_hint_below_it():
    road = [Pose(0.0, 0.0, 0.0), Pose(2.0, -1.0, 0.0), Pose(4.0, 3.0, 1.5)]
    message = road_markers(road)
    message.serialize(io.BytesIO())
    arrows = [each.pose.position for each in message.markers if each.ns == "road"]
    assert [(each.x, each.y) for each in arrows] == [(0.0, 0.0), (2.0, -1.0), (4.0, 3.0)]
    (hint,) = [each for each in message.markers if each.ns == "hint"]
    assert hint.pose.position.x == 2.0
    assert hint.pose.position.y < -2.0, "below the lowest point"


def test_world_of_unknown_road_has_a_start_only(tmp_path):
    road = road_ahead(tmp_path / "circuit1.world")
    assert [(pose.x, pose.y, pose.yaw) for pose in road] == [(0.0, 0.0, 0.0)]
    markers = road_markers(road).markers
    assert [marker.text for marker in markers if marker.ns == "start"] == ["start"]


@pytest.fixture(scope="module")
def master():
    """The environment of a master's nodes."""
    port = str(free_port())
    environment = {**os.environ, "ROS_MASTER_URI": f"http://localhost:{port}"}
    process = subprocess.Popen(["roscore", "-p", port], env=environment, stdout=subprocess.DEVNULL)
    wait_until(lambda: rosgraph.is_master_online(environment["ROS_MASTER_URI"]), "a master")
    yield environment
    process.send_signal(signal.SIGINT)
    process.wait()


@pytest.mark.parametrize(
    ("parameters", "problem"),
    [
        ([], "~goals_file: found nothing, must be the path of a file"),
        (["_goals_file:={bad}"], "{bad}:1: "),
        (["_goals_file:=x", "_world:=nowhere"], "there is no world named 'nowhere'"),
    ],
)
def test_node_that_cannot_begin_says_why(tmp_path, master, parameters, problem):
    bad = tmp_path / "bad.txt"
    bad.write_text("1 2\n", encoding="utf-8")
    command = ["rosrun", "f1tenth_gazebo", "navigation_goals", *(each.format(bad=bad) for each in parameters)]
    done = subprocess.run(command, env=master, capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == 2
    assert "navigation_goals: " in done.stderr
    assert problem.format(bad=bad) in done.stderr
