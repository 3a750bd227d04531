"""A planner with topics of its own that fails: its bag holds them, the result names what was too much."""

import subprocess
import sys

import pytest
import rosbag
from f1tenth_judge.places import lookup
from patience import PATIENCE
from result_schema import valid_result

LAUNCH = lookup.package_path(lookup.PACKAGE) / "test" / "planners" / "nodes" / "talkative.launch"
SAID = {
    "/clearance_ahead": "std_msgs/Float32",
    "/robot1/candidates": "visualization_msgs/MarkerArray",
    "/robot1/particles": "geometry_msgs/PoseArray",
    "/robot1/road_ahead": "nav_msgs/Path",
    "/robot1/steering_error": "std_msgs/Float64",
    "/robot1/target": "visualization_msgs/Marker",
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The results of a run into a wall."""
    results = tmp_path_factory.mktemp("results")
    command = [sys.executable, "-m", "f1tenth_judge", "race", "circuit1", "--planner", str(LAUNCH)]
    done = subprocess.run(
        [*command, "--results", str(results)], capture_output=True, text=True, timeout=PATIENCE
    )
    assert done.returncode == 1, done.stdout + done.stderr
    return results / "race_circuit1"


def test_bag_holds_what_a_planner_says_of_itself_but_no_costmaps(folder):
    with rosbag.Bag(str(folder / "run.bag")) as bag:
        topics = bag.get_type_and_topic_info().topics
    assert {name: topics[name].msg_type for name in SAID} == SAID
    assert not [name for name in topics if "costmap" in name]


def test_topic_that_grows_too_large_ends_early_and_is_named(folder):
    (said,) = valid_result(folder / "result.json")["not_written"]
    assert said.startswith("run.bag: /robot1/noise: left out from ")
    assert said.endswith(" s on, as it has more than 64 MB")
    with rosbag.Bag(str(folder / "run.bag")) as bag:
        assert 0 < bag.get_message_count("/robot1/noise") <= 16
