"""race.launch is `scenario race` on the master that runs."""

import json
import operator
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import rosbag
from f1tenth_scenarios.launch.private_master import private_master
from patience import PATIENCE

LAYOUT = Path(__file__).parents[2] / "foxglove" / "run.json"
# The command rosbags-convert, which is not on PATH here.
CONVERT = [sys.executable, "-c", "from rosbags.convert.cli import main; main()"]


@pytest.fixture
def race(tmp_path):
    """Runs race.launch with some arguments in a folder of its own; returns its output and the result."""

    def run(*arguments, options=""):
        more = f"more:=--results {tmp_path}/results {options}"
        command = ["roslaunch", "f1tenth_scenarios", "race.launch", *arguments, more]
        # roslaunch names the folder by this variable, as a shell sets it.
        environment = {**os.environ, "ROS_LOG_DIR": str(tmp_path / "log"), "PWD": str(tmp_path)}
        with private_master() as uri:
            environment |= {"ROS_MASTER_URI": uri, "ROS_HOSTNAME": "localhost"}
            done = subprocess.run(
                command, env=environment, cwd=tmp_path, capture_output=True, text=True, timeout=PATIENCE
            )
        (file,) = (tmp_path / "results").glob("*/result.json")
        return done.stdout + done.stderr, json.loads(file.read_text(encoding="utf-8"))

    return run


def test_race_of_two_is_judged_and_ends(race):
    said, result = race("planner2:=pursuit")
    assert "verdict:           success (expected success)" in said
    assert result["verdict"] == "success"
    assert [len(car["lap_times"]) for car in result["cars"].values()] == [1, 1]
    assert "REQUIRED process" not in said


def test_who_looks_on_sees_the_wheels(race, tmp_path):
    race("planner:=pursuit", options="--bag")
    (file,) = (tmp_path / "results").glob("*/run.bag")
    with rosbag.Bag(str(file)) as bag:
        frames = {each.child_frame_id for _, said, _ in bag.read_messages("/tf") for each in said.transforms}
    assert {"robot1/front_left_wheel", "robot1/rear_right_wheel"} <= frames


def test_bag_is_whole_in_the_tools_of_ros2_and_has_what_the_layout_shows(race, tmp_path):
    highlevel = pytest.importorskip("rosbags.highlevel")
    race("planner:=pursuit", options="--bag --set limits.timeout=4")
    (file,) = (tmp_path / "results").glob("*/run.bag")
    target = ["--dst", str(tmp_path / "mcap"), "--dst-storage", "mcap", "--dst-typestore", "ros2_humble"]
    subprocess.run([*CONVERT, "--src", str(file), *target], check=True, timeout=PATIENCE)
    with rosbag.Bag(str(file)) as bag, highlevel.AnyReader([tmp_path / "mcap"]) as converted:
        recorded = {name: each.message_count for name, each in bag.get_type_and_topic_info().topics.items()}
        assert {name: each.msgcount for name, each in converted.topics.items()} == recorded
        said = {end.topic: converted.deserialize(each, end.msgtype) for end, _, each in converted.messages()}
    layout = LAYOUT.read_text(encoding="utf-8")
    shown = re.findall(r"\"(/[\w/]+)", layout)
    assert {"/map", "/robot1/scan", "/robot1/drive"} <= set(shown) <= recorded.keys()
    plotted = re.findall(r"\"(/[\w/]+)\.([\w.]+)\"", layout)
    values = [float(operator.attrgetter(field)(said[topic])) for topic, field in plotted]
    assert len(values) == 5


def test_path_of_a_planner_counts_from_where_roslaunch_was_called(race, tmp_path):
    (tmp_path / "my.launch").write_text(
        "<launch><node pkg='map_server' type='map_saver' name='x' args='--none'/></launch>", encoding="utf-8"
    )
    said, result = race("planner:=my.launch")
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/x")
    assert "exit code 1" in said
