"""The same planner as a Python class without ROS and as a node with ROS drives the same, bit for bit."""

import json

import pytest
from f1tenth_judge.places.packages import package_path

from f1tenth_judge import cli

CLASSES = package_path("f1tenth_judge") / "test" / "drivers" / "python" / "classes.py"
NODE = package_path("f1tenth_scenarios") / "test" / "planners" / "nodes" / "class_node.launch"


@pytest.mark.parametrize("name", ["Follower", "Pursuer"])
def test_class_and_node_drive_the_same(tmp_path, name):
    as_node = [str(NODE), "--arg", f"folder:={CLASSES.parent}", "--arg", f"class:={name}"]
    found = []
    for how, planner in (("class", [f"{CLASSES}:{name}"]), ("node", as_node)):
        arguments = ["--results", str(tmp_path), "--name", how, "--set", "limits.timeout=40"]
        assert cli.main(["race", "circuit1", "--planner", *planner, *arguments]) == 0
        found.append(json.loads((tmp_path / how / "result.json").read_text(encoding="utf-8")))
    assert found[0]["trajectory_hash"] == found[1]["trajectory_hash"]
