"""description.launch must put one car's description and its transforms into its namespace."""

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from roslaunch.config import load_config_default

LAUNCH_FILE = Path(__file__).parent.parent / "launch" / "description.launch"


def load(*arguments):
    return load_config_default([(str(LAUNCH_FILE), list(arguments))], port=None, verbose=False)


def test_every_argument_is_documented():
    arguments = ElementTree.parse(LAUNCH_FILE).getroot().findall("arg")
    assert arguments
    assert not [a.get("name") for a in arguments if not a.get("doc")]


def test_description_is_in_the_namespace_of_the_car():
    config = load("car_name:=robot2")
    assert "<robot" in config.params["/robot2/robot_description"].value
    (node,) = config.nodes
    assert (node.namespace, node.package) == ("/robot2/", "robot_state_publisher")


@pytest.mark.parametrize(
    ("arguments", "tf_prefix"),
    [
        ([], "robot1"),
        (["car_name:=robot2"], "robot2"),
        (["frame_prefix:=/"], ""),
        (["frame_prefix:=a/"], "a"),
    ],
)
def test_frame_prefix_reaches_robot_state_publisher(arguments, tf_prefix):
    config = load(*arguments)
    values = [
        p.value for name, p in config.params.items() if name.endswith("robot_state_publisher/tf_prefix")
    ]
    assert values == [tf_prefix]
