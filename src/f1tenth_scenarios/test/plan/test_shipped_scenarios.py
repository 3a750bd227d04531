"""Every shipped scenario can be run: its file is valid, what it names is there, its launch file loads."""

from pathlib import Path

import pytest
import roslaunch.config
import rospkg
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.participants import participants
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.scenario.scenario import Localization, Verdict
from f1tenth_scenarios.launch.launch_file import launch_command, write_launch_file
from roslib.packages import find_resource

NAMES = lookup.scenario_names()
NODES = {
    "race": ("move_base", "race_mgr"),
    "pursuit": ("pure_pursuit",),
    "commands": ("command_driver",),
    "package://f1tenth_scenarios/launch/drivers/visual_odometry.launch": ("pure_pursuit", "stereo_odometry"),
}


@pytest.fixture(params=NAMES)
def plan(request, tmp_path):
    made = make_plan(request.param, tmp_path)
    made.log_folder.mkdir()
    return made


def load(plan):
    write_launch_file(plan)
    return roslaunch.config.load_config_default([str(plan.launch_file)], None)


def test_there_is_one_for_each_circuit():
    files = (lookup.package_path(lookup.GAZEBO_PACKAGE) / "circuits").glob("*.yaml")
    circuits = {file.stem for file in files}
    assert circuits
    assert circuits <= set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_each_has_its_rostest_file(name):
    (file,) = find_resource(lookup.PACKAGE, f"{name}.test")
    assert rospkg.get_package_name(file) == lookup.PACKAGE
    assert f'args="{name}"' in Path(file).read_text(encoding="utf-8")


def test_any_planner_has_the_time_of_a_lap_with_a_metre_per_second(plan):
    laps = plan.course and plan.scenario.expected is Verdict.SUCCESS and plan.scenario.laps
    if laps and all(car.goals in (None, plan.scenario.world) for car in plan.scenario.cars):
        assert plan.scenario.limits.timeout >= 30.0 + laps * plan.course.length / 1.0


def test_launch_file_starts_what_the_scenario_says(plan):
    config = load(plan)
    nodes = {f"{node.namespace}{node.name}".lstrip("/") for node in config.nodes}
    assert "sim2d" in nodes
    for car in plan.scenario.cars:
        driven_by = set(NODES[car.driver.name])
        driven_by |= {"faulty_inputs"} if car.input_faults else set()
        driven_by |= {"beam_dropper"} if car.dropped_beams else set()
        driven_by |= {"amcl"} if plan.scenario.localization is Localization.AMCL else {"map_to_odom"}
        assert {f"{car.name}/{node}" for node in driven_by} <= nodes
    assert ("race_starter" in nodes) == plan.has_countdown


def test_launch_file_hands_the_scenario_to_the_simulator(plan):
    parameters = {name: each.value for name, each in load(plan).params.items()}
    assert parameters["/sim2d/world"] == str(plan.run_world)
    assert parameters["/sim2d/participants"] == participants(plan)
    assert parameters["/sim2d/lockstep"] is plan.scenario.lockstep
    limits = plan.scenario.limits
    timeout = limits.answer + (limits.load if "/robot1/proxy_driver/loading" in parameters else 0.0)
    assert parameters["/sim2d/lockstep_timeout"] == timeout
    assert parameters["/sim2d/lockstep_startup_timeout"] == 60.0 + timeout
    assert parameters["/sim2d/seed"] == plan.scenario.seed
    assert parameters["/sim2d/record"] == str(plan.record_file)
    assert parameters["/sim2d/result_file"] == str(plan.simulator_result_file)
    for car in plan.scenario.cars:
        assert parameters[f"/sim2d/cars/{car.name}/x"] == plan.cars[car.name].start.x
        is_changed = any(each is not None for each in (car.mu, car.actuation_latency, car.model))
        assert (f"/sim2d/cars/{car.name}/vehicle" in parameters) == is_changed


def test_launch_file_hands_the_scenario_to_the_drivers(plan):
    config = load(plan)
    parameters = {name: each.value for name, each in config.params.items()}
    for car in plan.scenario.cars:
        if car.driver.name == "race" and car.speed_max is not None:
            assert parameters[f"/{car.name}/move_base/RacerROS/max_vel_x"] == car.speed_max
        if car.acceleration_max is not None:
            planner = f"/{car.name}/move_base/RacerROS"
            assert parameters[f"{planner}/acc_lim_x"] == car.acceleration_max
            assert parameters[f"{planner}/max_lateral_acceleration"] == car.acceleration_max
        if car.driver.name == "pursuit":
            assert parameters[f"/{car.name}/pure_pursuit/speed_max"] == car.speed_max
            assert parameters[f"/{car.name}/pure_pursuit/start_at"] > plan.scenario.time_to_start
            awaits = parameters[f"/{car.name}/pure_pursuit/await_start"]
            assert awaits == (not plan.scenario.lockstep)
        if car.driver.name == "race":
            is_amcl = plan.scenario.localization is Localization.AMCL
            first = f"{car.name}/amcl" if is_amcl else ""
            assert parameters[f"/{car.name}/move_base/lockstep_after"] == first
            assert parameters["/sim2d/odometry"] == ("wheel" if is_amcl else "perfect")
        if car.dropped_beams:
            (planner,) = (node for node in config.nodes if node.name == "move_base")
            assert ["scan", "scan_dropped"] in planner.remap_args
        for fault in car.input_faults:
            (planner,) = (node for node in config.nodes if node.name == "move_base")
            topics = {"scan": "scan", "odom": "odom", "tf": "/tf"}
            for name in fault.inputs:
                assert [topics[name.value], f"{name.value}_faulty"] in planner.remap_args
            assert {"input": fault.inputs[0].value, "at": fault.at, "until": fault.until} in [
                {key: each[key] for key in ("input", "at", "until")}
                for each in parameters[f"/{car.name}/faulty_inputs/faults"]
            ]


def test_command_names_the_launch_file(plan):
    assert launch_command(plan.launch_file)[-1] == str(plan.launch_file)
