"""Every shipped launch and parameter file loads, and says what it ought to."""

from pathlib import Path
from xml.etree import ElementTree

import pytest
import roslaunch.config
import roslaunch.xmlloader
import yaml

PACKAGE = Path(__file__).parents[1]
LAUNCH_FILES = sorted((PACKAGE / "launch").glob("*.launch"))
PARAMETER_FILES = sorted((PACKAGE / "config").glob("*.yaml"))


def load(name, *arguments):
    config = roslaunch.config.ROSLaunchConfig()
    path = str(PACKAGE / "launch" / name)
    roslaunch.xmlloader.XmlLoader().load(path, config, argv=list(arguments), verbose=False)
    return config


def parameters(config):
    return {name: parameter.value for name, parameter in config.params.items()}


def nodes(config):
    return [(node.namespace, node.package, node.type, node.name) for node in config.nodes]


@pytest.mark.parametrize("path", LAUNCH_FILES, ids=lambda path: path.name)
def test_launch_file_loads_with_its_defaults(path):
    assert nodes(load(path.name))


@pytest.mark.parametrize("path", LAUNCH_FILES, ids=lambda path: path.name)
def test_every_argument_is_documented(path):
    arguments = ElementTree.parse(path).getroot().findall("arg")
    assert arguments
    assert [argument.get("name") for argument in arguments if not argument.get("doc")] == []


@pytest.mark.parametrize("path", PARAMETER_FILES, ids=lambda path: path.name)
def test_parameter_file_holds_parameters(path):
    assert isinstance(yaml.safe_load(path.read_text()), dict)


def test_move_base_runs_in_the_namespace_of_its_car():
    assert nodes(load("move_base.launch", "car_name:=ego")) == [
        ("/ego/", "move_base", "move_base", "move_base")
    ]


@pytest.mark.parametrize(
    ("arguments", "prefix"),
    [((), "robot1/"), (("car_name:=ego",), "ego/"), (("frame_prefix:=/",), ""), (("frame_prefix:=a",), "a/")],
)
def test_frames_carry_the_car_s_prefix(arguments, prefix):
    names = {
        name.split("/move_base/")[1]: value
        for name, value in parameters(load("move_base.launch", *arguments)).items()
    }
    assert names["global_costmap/global_frame"] == "map"
    assert names["local_costmap/global_frame"] == f"{prefix}odom"
    assert names["global_costmap/robot_base_frame"] == f"{prefix}base_footprint"
    assert names["local_costmap/robot_base_frame"] == f"{prefix}base_footprint"


def test_topics_are_remapped_as_asked():
    (node,) = load("move_base.launch", "odom_topic:=odom", "map_topic:=/other").nodes
    assert ["map", "/other"] in node.remap_args
    assert ["odom", "odom"] in node.remap_args


def test_lockstep_is_off_unless_asked_for():
    assert parameters(load("move_base.launch"))["/robot1/move_base/lockstep"] is False
    assert parameters(load("move_base.launch", "lockstep:=true"))["/robot1/move_base/lockstep"] is True


def test_parameter_files_may_come_from_elsewhere(tmp_path):
    for path in PARAMETER_FILES:
        (tmp_path / path.name).write_text(path.read_text())
    (tmp_path / "move_base.yaml").write_text("controller_frequency: 7.0\n")
    config = load("move_base.launch", f"config:={tmp_path}")
    assert parameters(config)["/robot1/move_base/controller_frequency"] == 7.0


def test_static_localization_is_the_identity_from_map_to_odom():
    (node,) = load("localization.launch").nodes
    assert (node.package, node.type) == ("tf2_ros", "static_transform_publisher")
    assert node.args == "0 0 0 0 0 0 map robot1/odom"


def test_localization_can_be_left_to_another_node():
    assert load("localization.launch", "localization:=none").nodes == []


def test_amcl_has_the_car_s_frames_and_start():
    config = load("localization.launch", "localization:=amcl", "car_name:=ego", "x:=1.5", "yaw:=-0.5")
    assert nodes(config) == [("/ego/", "amcl", "amcl", "amcl")]
    assert ["map", "/map"] in config.nodes[0].remap_args
    wanted = {
        "odom_frame_id": "ego/odom",
        "base_frame_id": "ego/base_footprint",
        "global_frame_id": "map",
        "initial_pose_x": 1.5,
        "initial_pose_y": 0.0,
        "initial_pose_a": -0.5,
        "use_map_topic": True,
        "lockstep": False,
        "seed": 0,
    }
    given = parameters(config)
    assert {name: given[f"/ego/amcl/{name}"] for name in wanted} == wanted


def test_unknown_localization_is_refused_by_its_name():
    with pytest.raises(roslaunch.RLException, match="'guess'"):
        load("localization.launch", "localization:=guess")


@pytest.mark.parametrize(("cars", "name"), [("1", "one_car.rviz"), ("2", "two_cars.rviz")])
def test_rviz_shows_as_many_cars_as_asked_for(cars, name):
    (node,) = (each for each in load("rviz.launch", f"cars:={cars}").nodes if each.name == "rviz")
    assert f"{PACKAGE}/rviz/{name}" in node.args


@pytest.mark.parametrize(
    ("arguments", "namespaces"),
    [((), ["/robot1/"]), (("cars:=2",), ["/robot1/", "/robot2/"]), (("car_name:=ego",), ["/ego/"])],
)
def test_goals_and_contacts_of_each_car_are_marked(arguments, namespaces):
    started = nodes(load("rviz.launch", *arguments))
    assert [each[0] for each in started if each[3] == "race_markers"] == namespaces


def test_rviz_takes_a_configuration_of_one_s_own():
    loaded = load("rviz.launch", "config:=/my own.rviz", "car_name:=ego").nodes
    (node,) = (each for each in loaded if each.name == "rviz")
    assert node.args == "--config '/my own.rviz' --car-name 'ego' --frame-prefix 'ego/'"
