"""Runs side by side do not hear each other, whatever the user's environment says."""

import socket

import pytest
from f1tenth_judge.drivers.ros2 import isolation
from f1tenth_judge.drivers.ros2.isolation import child_environment, private_domain
from f1tenth_judge.errors import ScenarioError


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
