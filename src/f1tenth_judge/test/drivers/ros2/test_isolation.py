"""Runs side by side do not hear each other, whatever the user's environment says."""

import os
import shlex
import socket
import subprocess
import sys
from pathlib import Path

import pytest
from f1tenth_judge.drivers.ros2 import isolation
from f1tenth_judge.drivers.ros2.isolation import child_environment, private_domain
from f1tenth_judge.errors import ScenarioError
from result_schema import valid_result

PLANNERS = Path(__file__).parent / "planners"
HOSTILE = {
    "ROS_DOMAIN_ID": "0",
    "ROS_LOCALHOST_ONLY": "0",
    "ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET",
    "CYCLONEDDS_URI": "file:///nowhere.xml",
    "RMW_IMPLEMENTATION": "rmw_zenoh_cpp",
}


def test_runs_side_by_side_drive_as_each_does_alone(race, tmp_path):
    drives, stands = (
        shlex.join([sys.executable, str(PLANNERS / f"{file}.py"), how])
        for file, how in (("gap", "by_subscription"), ("misbehaving", "hears_latched_odometry"))
    )
    words = (sys.executable, "-m", "f1tenth_judge.drivers.ros2", "circuit1", "--set", "limits.timeout=5")
    folders = [tmp_path / "one", tmp_path / "other"]
    runs = [
        subprocess.Popen([*words, "--results", folder, planner], env=os.environ | HOSTILE)
        for folder, planner in zip(folders, (drives, stands))
    ]
    assert [run.wait() for run in runs] == [1, 1]
    one, other = (valid_result(folder / "race_circuit1" / "result.json") for folder in folders)
    assert (one["verdict"], other["verdict"], one["lockstep"]) == ("timeout", "timeout", True)
    assert one["trajectory_hash"] != other["trajectory_hash"]
    assert one["trajectory_hash"] == race(drives)["trajectory_hash"]


def test_domain_is_somebody_elses_only_when_it_is_given_back():
    with private_domain() as one:
        with private_domain() as other:
            assert one != other
        with private_domain() as again:
            assert again == other


def test_domain_with_a_participant_of_others_is_left_to_them():
    with private_domain() as free:
        pass
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as port:
        port.bind(("", 7400 + 250 * free + 10))
        with private_domain() as domain:
            assert domain != free


def test_no_domain_left_is_said(monkeypatch):
    with private_domain() as first:
        monkeypatch.setattr(isolation, "_LAST", first)
        with (
            pytest.raises(ScenarioError, match=f"all DDS domains from 1 to {first} are in use"),
            private_domain(),
        ):
            pass


def test_environment_names_the_domain_and_the_loopback_interface():
    environment = child_environment(7, {"ROS_DOMAIN_ID": "0", "CYCLONEDDS_URI": "file:///mine.xml"})
    assert environment["ROS_DOMAIN_ID"] == "7"
    assert "127.0.0.1" in environment["CYCLONEDDS_URI"]
    assert "mine.xml" not in environment["CYCLONEDDS_URI"]
    assert environment["ROS_AUTOMATIC_DISCOVERY_RANGE"] == "LOCALHOST"


@pytest.mark.parametrize(
    ("installed", "wanted", "middleware", "localhost_only"),
    [
        (["rmw_cyclonedds_cpp", "rmw_fastrtps_cpp"], "", "rmw_cyclonedds_cpp", "0"),
        (["rmw_cyclonedds_cpp", "rmw_fastrtps_cpp"], "rmw_fastrtps_cpp", "rmw_fastrtps_cpp", "1"),
        (["rmw_fastrtps_cpp", "rmw_zenoh_cpp"], "rmw_zenoh_cpp", "rmw_fastrtps_cpp", "1"),
        ([], "rmw_zenoh_cpp", "", "1"),
    ],
)
def test_middleware_is_one_that_is_installed_and_speaks_dds(
    tmp_path, installed, wanted, middleware, localhost_only
):
    (tmp_path / "lib").mkdir()
    for name in installed:
        (tmp_path / "lib" / f"lib{name}.so").touch()
    environment = child_environment(7, {"AMENT_PREFIX_PATH": str(tmp_path), "RMW_IMPLEMENTATION": wanted})
    assert (environment["RMW_IMPLEMENTATION"], environment["ROS_LOCALHOST_ONLY"]) == (
        middleware,
        localhost_only,
    )
