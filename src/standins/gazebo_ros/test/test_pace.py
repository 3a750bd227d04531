"""The pace of a world is that of its physics."""

import pytest
from gazebo_ros.errors import UsageError
from gazebo_ros.pace import real_time_factor

PHYSICS = """
<physics name="slow" type="ode"><real_time_update_rate>500</real_time_update_rate></physics>
<physics name="fast" type="ode" default="true">
  <max_step_size>0.002</max_step_size><real_time_update_rate>5000</real_time_update_rate>
</physics>
<physics name="free" type="ode"><real_time_update_rate>0</real_time_update_rate></physics>
"""


@pytest.fixture(name="world")
def _world(tmp_path):
    def write(physics):
        path = tmp_path / "a.world"
        path.write_text(f'<sdf version="1.6"><world name="w">{physics}</world></sdf>')
        return str(path)

    return write


@pytest.mark.parametrize(
    ("physics", "profile", "factor"),
    [
        (PHYSICS, None, 10.0),
        (PHYSICS, "slow", 0.5),
        (PHYSICS, "free", 0.0),
        ("<physics type='ode'/>", None, 1.0),
        ("<physics type='ode'><max_step_size>0.01</max_step_size></physics>", None, 10.0),
        ("", None, None),
    ],
)
def test_pace_is_the_update_rate_times_the_step(world, physics, profile, factor):
    assert real_time_factor(world(physics), profile) == factor


def test_what_is_no_xml_says_nothing(tmp_path):
    path = tmp_path / "map.yaml"
    path.write_text("image: map.png")
    assert real_time_factor(str(path)) is None


@pytest.mark.parametrize(
    ("physics", "profile", "message"),
    [
        (PHYSICS, "quick", "--profile: found 'quick', {} has slow, fast, free"),
        ("", "quick", "--profile: found 'quick', {} has no <physics>"),
        (
            "<physics><real_time_update_rate>many</real_time_update_rate></physics>",
            None,
            "{}: world/physics/real_time_update_rate: found 'many', expected a number >= 0",
        ),
    ],
)
def test_what_cannot_be_a_pace_is_refused(world, physics, profile, message):
    path = world(physics)
    with pytest.raises(UsageError) as error:
        real_time_factor(path, profile)
    assert str(error.value) == message.format(path)
