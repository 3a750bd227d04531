"""Every launch file must parse in each of its uses, and say what its arguments mean."""

import functools
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from roslaunch.config import load_config_default

PACKAGE = Path(__file__).parent.parent
LAUNCH_FILES = sorted((PACKAGE / "launch").glob("*.launch"))
WORLDS = sorted(world.stem for world in (PACKAGE / "worlds").glob("*.world"))


@functools.cache
def load(name, *arguments):
    return load_config_default([(str(PACKAGE / "launch" / name), list(arguments))], port=None, verbose=False)


def value(config, name):
    return config.params[name].value


def node_names(config):
    return {node.namespace + node.name for node in config.nodes}


@pytest.mark.parametrize("path", LAUNCH_FILES, ids=lambda path: path.name)
def test_every_argument_is_documented(path):
    arguments = ElementTree.parse(path).getroot().findall("arg")
    assert arguments
    assert not [a.get("name") for a in arguments if not a.get("doc")]


@pytest.mark.parametrize("path", LAUNCH_FILES, ids=lambda path: path.name)
def test_defaults_are_enough(path):
    assert load(path.name).nodes


@pytest.mark.parametrize("name", ["sim_one_car.launch", "sim_two_cars.launch"])
def test_browsers_look_on_if_that_is_wanted(name):
    assert "/live" not in node_names(load(name))
    assert "/live" in node_names(load(name, "live:=true"))


@pytest.mark.parametrize("world", [WORLDS[0], WORLDS[-1]])
def test_a_named_world_brings_its_map(world):
    config = load("sim_one_car.launch", f"world_file_name:={world}")
    assert value(config, "/sim2d/world") == str(PACKAGE / "worlds" / f"{world}.world")
    (server,) = [node for node in config.nodes if node.type == "map_server"]
    assert server.args == f"'{PACKAGE}/maps/{world}.yaml'"


def test_a_relative_path_is_a_world_too(tmp_path, monkeypatch):
    (tmp_path / "mine.world").write_text("<sdf version='1.6'><world name='mine'/></sdf>")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PWD", str(tmp_path))
    config = load("sim_one_car.launch", "world_file_name:=mine.world")
    assert value(config, "/sim2d/world") == str(tmp_path / "mine.world")
    (server,) = [node for node in config.nodes if node.type == "map_server"]
    assert server.args == f"'{tmp_path}/mine.yaml'"


def test_a_map_as_world_is_served_itself(tmp_path):
    track = tmp_path / "track_map.yaml"
    track.write_text((PACKAGE / "maps" / "circuit1.yaml").read_text())
    (tmp_path / "circuit1.pgm").write_bytes((PACKAGE / "maps" / "circuit1.pgm").read_bytes())
    config = load("sim_one_car.launch", f"world_file_name:={track}")
    assert value(config, "/sim2d/world") == str(track)
    (server,) = [node for node in config.nodes if node.type == "map_server"]
    assert server.args == f"'{track}'"


def test_a_map_can_be_named():
    config = load("sim_one_car.launch", "map_file:=/elsewhere/a.yaml")
    (server,) = [node for node in config.nodes if node.type == "map_server"]
    assert server.args == "'/elsewhere/a.yaml'"


def test_a_wrong_world_is_named_with_the_known_ones_before_anything_starts():
    command = ["roslaunch", "f1tenth_gazebo", "sim_one_car.launch", "world_file_name:=circuit9", "--nodes"]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode != 0
    lines = [line for line in result.stderr.splitlines() if line.startswith("world_file_name: ")]
    known = ", ".join(WORLDS)
    assert lines == [
        f"world_file_name: there is no world named 'circuit9'; known names: {known}; a path works, too"
    ]
    assert "Traceback" not in result.stderr


def test_an_unreadable_world_is_refused_before_anything_starts(tmp_path):
    world = tmp_path / "broken.world"
    world.write_text("<sdf version='1.6'><world name='w'></sdf>")
    command = ["roslaunch", "f1tenth_gazebo", "sim_one_car.launch", f"world_file_name:={world}", "--nodes"]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode != 0
    (line,) = [line for line in result.stderr.splitlines() if line.startswith("world_file_name: ")]
    assert line.startswith(f"world_file_name: {world}: line 1: malformed XML")
    assert "Traceback" not in result.stderr


def test_a_wrong_simulator_is_refused():
    with pytest.raises(ValueError, match="simulator must be sim2d or gazebo"):
        load("sim_one_car.launch", "simulator:=stage")


def test_one_car_stands_on_the_start_line_with_navigation():
    config = load("sim_one_car.launch")
    assert node_names(config) == {
        "/sim2d",
        "/map_server",
        "/robot1/robot_state_publisher",
        "/robot1/collision_detection",
        "/robot1/map_to_odom",
        "/robot1/move_base",
    }
    assert value(config, "/sim2d/cars/robot1/frame_prefix") == "robot1/"
    assert value(config, "/use_sim_time") is True


def test_car_starts_where_the_world_says_unless_told():
    pose = [f"/sim2d/cars/robot1/{key}" for key in ("x", "y", "yaw")]
    assert not set(pose) & set(load("sim_one_car.launch").params)
    config = load("sim_one_car.launch", "x:=1", "y:=0.0", "yaw:=-0.5")
    assert [value(config, name) for name in pose] == [1.0, 0.0, -0.5]


def test_simulator_gets_its_parameters_with_the_right_types():
    config = load(
        "sim_one_car.launch",
        *(
            "real_time_factor:=0",
            "lockstep:=true",
            "seed:=7",
            "record:=/tmp/r.csv",
            "result_file:=/tmp/r.json",
        ),
        *("lockstep_timeout:=3", "lockstep_startup_timeout:=9", "odometry:=wheel"),
    )
    values = {name[7:]: p.value for name, p in config.params.items() if name.startswith("/sim2d/")}
    assert values["real_time_factor"] == 0.0
    assert isinstance(values["real_time_factor"], float)
    assert values["lockstep"] is True
    assert values["participants"] == ["robot1/move_base"]
    assert (values["lockstep_timeout"], values["lockstep_startup_timeout"]) == (3.0, 9.0)
    assert values["seed"] == 7
    assert (values["record"], values["result_file"]) == ("/tmp/r.csv", "/tmp/r.json")
    assert values["odometry"] == "wheel"


def test_without_navigation_the_car_is_the_participant():
    config = load("sim_one_car.launch", "navigation:=false", "lockstep:=true")
    assert "/robot1/move_base" not in node_names(config)
    assert value(config, "/sim2d/participants") == ["robot1"]


def test_participants_can_be_named():
    config = load("sim_one_car.launch", "participants:=[robot1/move_base, robot1/race_mgr]")
    assert value(config, "/sim2d/participants") == ["robot1/move_base", "robot1/race_mgr"]


def test_wheel_odometry_leaves_map_to_odom_to_a_localizer():
    assert "/robot1/map_to_odom" not in node_names(load("sim_one_car.launch", "odometry:=wheel"))


def test_frame_prefix_can_be_empty():
    assert value(load("sim_one_car.launch", "frame_prefix:=/"), "/sim2d/cars/robot1/frame_prefix") == ""


def test_vehicle_is_passed_on_only_when_named():
    assert "/sim2d/cars/robot1/vehicle" not in load("sim_one_car.launch").params
    config = load("sim_one_car.launch", "vehicle:=/cars/fast.yaml")
    assert value(config, "/sim2d/cars/robot1/vehicle") == "/cars/fast.yaml"


def test_two_cars_start_side_by_side():
    config = load("sim_two_cars.launch", "lockstep:=true")
    assert [value(config, f"/sim2d/cars/robot{n}/y") for n in (1, 2)] == [0.3, -0.3]
    assert all(value(config, f"/sim2d/cars/robot{n}/relative_to_start") for n in (1, 2))
    assert {"/robot1/move_base", "/robot2/move_base"} <= node_names(config)
    assert value(config, "/sim2d/participants") == ["robot1/move_base", "robot2/move_base"]


def test_a_start_of_two_cars_that_is_told_is_one_in_the_world():
    config = load("sim_two_cars.launch", "robot2_x:=-1", "robot2_y:=0")
    pose = [value(config, f"/sim2d/cars/robot2/{key}") for key in ("x", "y", "yaw")]
    assert pose == [-1.0, 0.0, 0.0]
    assert [value(config, f"/sim2d/cars/robot{n}/relative_to_start") for n in (1, 2)] == [True, False]


def test_gui_starts_rviz():
    assert "/rviz" in node_names(load("sim_one_car.launch", "gui:=true"))
    assert "/rviz" in node_names(load("sim_two_cars.launch", "gui:=true"))


def test_gazebo_takes_the_place_of_the_simulator():
    """With the gazebo_ros that is there: the original, or the stand-in of the same interface."""
    config = load("sim_one_car.launch", "simulator:=gazebo", "y:=0.5")
    (server,) = [node for node in config.nodes if node.type == "gzserver"]
    assert server.args.split()[-1] == f"{PACKAGE}/worlds/circuit1.world"
    (spawn,) = [node for node in config.nodes if node.type == "spawn_model"]
    assert "-model robot1 -robot_namespace robot1 -x 0.0 -y 0.5 -Y 0.0" in spawn.args
    assert "/sim2d" not in node_names(config)


def test_amcl_acts_before_the_planner_and_starts_where_the_car_does():
    arguments = ("localization:=amcl", "odometry:=wheel", "lockstep:=true", "seed:=3", "x:=1.0", "y:=2.0")
    config = load("sim_one_car.launch", *arguments)
    assert value(config, "/sim2d/participants") == ["robot1/amcl", "robot1/move_base"]
    assert value(config, "/robot1/move_base/lockstep_after") == "robot1/amcl"
    assert value(config, "/robot1/amcl/lockstep") is True
    assert value(config, "/robot1/move_base/RacerROS/min_obstacle_dist") == 0.15
    assert [value(config, f"/robot1/amcl/{name}") for name in ("seed", "initial_pose_y")] == [3, 2.0]


def test_each_of_two_cars_has_its_own_amcl():
    config = load("sim_two_cars.launch", "localization:=amcl", "odometry:=wheel")
    assert {"/robot1/amcl", "/robot2/amcl"} <= node_names(config)
    assert value(config, "/robot2/amcl/initial_pose_y") == -0.3
    assert value(config, "/sim2d/participants")[:2] == ["robot1/amcl", "robot2/amcl"]
