"""Driver and referee do not share a tree of parameters."""

import re
import xml.etree.ElementTree as ElementTree

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.scenario.driver import Driver
from f1tenth_scenarios.launch.foreign_parameters import CAR_NODES, RUN_NODES
from f1tenth_scenarios.launch.launch_file import write_launch_file
from roslaunch.config import ROSLaunchConfig
from roslaunch.xmlloader import XmlLoader


def launched(folder, *lines):
    """The configuration that roslaunch makes of a race of a planner with these lines in its launch file."""
    planner = folder / "planner.launch"
    node = '<node pkg="f1tenth_scenarios" type="pure_pursuit" name="planner"/>'
    planner.write_text(f"<launch>{node}{''.join(lines)}</launch>", encoding="utf-8")
    plan = plan_race(Race("circuit1", 1, [Driver(str(planner))]), folder / "results")
    plan.log_folder.mkdir(parents=True, exist_ok=True)
    write_launch_file(plan)
    config = ROSLaunchConfig()
    XmlLoader().load(str(plan.launch_file), config, verbose=False)
    return config


def text(name, value, kind="str"):
    return f'<param name="{name}" value="{value}" type="{kind}"/>'


@pytest.mark.parametrize(
    ("lines", "named"),
    [
        (text("/sim2d/physics_step", 0.01, "double"), "/sim2d/physics_step"),
        (text("/sim2d/seed", 7, "int"), "/sim2d/seed"),
        (text("/sim2d/cars/robot1/vehicle", "mine.yaml"), "/sim2d/cars/robot1/vehicle"),
        ("<rosparam>{/sim2d: {record: /dev/null}}</rosparam>", "/sim2d/record"),
        ('<rosparam ns="/sim2d">seed: 7</rosparam>', "/sim2d/seed"),
        ('<group ns="/sim2d"><param name="seed" value="7"/></group>', "/sim2d/seed"),
        (text("collision_detection/ground_models", "walls"), "/robot1/collision_detection/ground_models"),
        (text("proxy_driver/patience", 1000, "double"), "/robot1/proxy_driver/patience"),
        (text("/map_server/frame_id", "odom"), "/map_server/frame_id"),
        (text("/use_sim_time", "false", "bool"), "/use_sim_time to False"),
        ('<param name="/sim2d/seed" command="echo 7"/>', "/sim2d/seed"),
    ],
)
def test_driver_that_sets_what_is_the_runs_is_refused_before_anything_starts(tmp_path, lines, named):
    with pytest.raises(ScenarioError, match=re.escape(f"planner.launch: sets the parameter {named}, ")):
        launched(tmp_path, lines)


@pytest.mark.parametrize(
    ("which", "named"),
    [
        ('param="/sim2d/seed"', "/sim2d/seed"),
        ('ns="/sim2d"', "/sim2d"),
        ('ns="/"', "/"),
        ("", "/robot1"),
        ('param="/use_sim_time"', "/use_sim_time"),
        ('param="collision_detection/ground_models"', "/robot1/collision_detection/ground_models"),
    ],
)
def test_driver_that_deletes_what_is_the_runs_is_refused(tmp_path, which, named):
    with pytest.raises(ScenarioError, match=re.escape(f"planner.launch: deletes the parameter {named}, ")):
        launched(tmp_path, f'<rosparam command="delete" {which}/>')


def test_driver_may_delete_what_is_its_own(tmp_path):
    (deleted,) = launched(tmp_path, '<rosparam command="delete" param="planner/old"/>').executables
    assert deleted.args == ("delete", "/robot1/planner/old")


def test_commands_of_a_launch_file_are_run_by_the_run_alone(tmp_path):
    planner = f"touch {tmp_path}/ran.$PPID; echo 1"
    launched(tmp_path, f'<param name="x" command="sh -c \'{planner}\'"/>')
    assert len([*tmp_path.glob("ran.*")]) == 1, "by roslaunch, which reads the run's launch file here"


def test_what_a_command_of_a_launch_file_has_set_before_is_cleared(tmp_path):
    assert launched(tmp_path).clear_params == ["/sim2d/"]


def test_environment_and_remappings_of_a_driver_are_its_own(tmp_path):
    lines = (
        '<env name="LD_PRELOAD" value="/mine.so"/>',
        '<remap from="/clock" to="/mine"/>',
        '<machine name="mine" address="localhost" env-loader="/mine.sh" default="true"/>',
    )
    config = launched(tmp_path, *lines)
    others = [each for each in config.nodes if each.name in (*RUN_NODES, *CAR_NODES)]
    assert len(others) > 3
    for node in others:
        assert "LD_PRELOAD" not in dict(node.env_args)
        assert ("/clock", "/mine") not in node.remap_args
        assert node.machine is None or node.machine.env_loader != "/mine.sh"


def test_what_a_driver_sets_for_itself_is_its_own_affair(tmp_path):
    own = (
        text("planner/speed", 2.0, "double"),
        text("/wall_follow/gain", 1.0, "double"),
        text("robot_name", "x"),
        text("/use_sim_time", "true", "bool"),
    )
    parameters = launched(tmp_path, *own).params
    assert parameters["/robot1/planner/speed"].value == 2.0
    assert parameters["/wall_follow/gain"].value == 1.0


@pytest.mark.parametrize("name", ["robot_description", "/robot1/robot_description"])
def test_description_that_a_driver_sets_for_rviz_is_not_that_of_the_judged_car(tmp_path, name):
    config = launched(tmp_path, text(name, "my own car"))
    assert "my own car" not in config.params["/robot1/robot_description"].value
    assert "<robot" in config.params["/robot1/robot_description"].value


def test_all_nodes_of_a_run_are_known(tmp_path):
    nodes = {f"{node.namespace}{node.name}".strip("/") for node in launched(tmp_path).nodes}
    known = {*RUN_NODES, *(f"robot1/{name}" for name in CAR_NODES), "robot1/planner"}
    assert nodes <= known
    assert {"sim2d", "robot1/collision_detection", "robot1/proxy_driver"} <= nodes


def test_launch_file_that_cannot_be_read_is_left_for_roslaunch_to_tell(tmp_path):
    planner = tmp_path / "planner.launch"
    planner.write_text("<launch><include file='/no/such.launch'/></launch>", encoding="utf-8")
    plan = plan_race(Race("circuit1", 1, [Driver(str(planner))]), tmp_path / "results")
    plan.log_folder.mkdir(parents=True)
    write_launch_file(plan)
    assert ElementTree.parse(plan.launch_file).getroot().find("group") is not None
