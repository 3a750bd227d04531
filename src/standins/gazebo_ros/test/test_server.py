"""What gzserver leaves on the parameter server."""

import pytest
import rospy
from gazebo_ros.server import set_parameters
from gazebo_ros.server_options import parse

FREE = "<physics><real_time_update_rate>0</real_time_update_rate></physics>"


@pytest.fixture(name="parameters")
def _parameters(monkeypatch):
    """A parameter server: values by full name."""
    values = {}
    monkeypatch.setattr(rospy, "set_param", values.__setitem__)
    monkeypatch.setattr(rospy, "get_param", values.get)
    monkeypatch.setattr(rospy, "has_param", values.__contains__)
    monkeypatch.setattr(rospy, "delete_param", values.pop)
    return values


@pytest.fixture(name="start")
def _start(tmp_path):
    def start(physics, *arguments):
        world = tmp_path / "a.world"
        world.write_text(f'<sdf version="1.6"><world name="w">{physics}</world></sdf>')
        set_parameters("/gazebo", parse([*arguments, str(world)])[0])

    return start


def test_what_an_earlier_one_said_does_not_hold_for_the_next(parameters, start):
    start(FREE, "--seed", "7")
    assert parameters["/gazebo/sim2d/real_time_factor"] == 0.0
    assert parameters["/gazebo/sim2d/seed"] == 7
    start("")
    assert [name for name in parameters if name.startswith("/gazebo/")] == [
        "/gazebo/sim2d/world",
        "/gazebo/sim2d/paused",
    ]


def test_what_the_user_has_set_stays(parameters, start):
    parameters["/gazebo/sim2d/seed"] = 3
    start(FREE)
    parameters["/gazebo/sim2d/real_time_factor"] = 5.0
    start("")
    assert parameters["/gazebo/sim2d/seed"] == 3
    assert parameters["/gazebo/sim2d/real_time_factor"] == 5.0
