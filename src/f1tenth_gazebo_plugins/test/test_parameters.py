import pytest
from f1tenth_gazebo_plugins.parameters import Parameters, read_parameters
from workspace_support.nodes import ParameterError

NODE = "/robot1/collision_detection"


def test_defaults_are_the_four_bumpers_and_the_ground():
    assert read_parameters(NODE, {}) == Parameters(
        topics=("bumper_front", "bumper_rear", "bumper_left", "bumper_right"), ground_models=("ground_plane",)
    )


def test_reads_what_is_there():
    found = {"topics": ["a", "b"], "ground_models": []}
    assert read_parameters(NODE, found) == Parameters(topics=("a", "b"), ground_models=())


@pytest.mark.parametrize(
    ("found", "message"),
    [
        ({"topic": []}, "/topic: unknown; allowed: topics, ground_models"),
        ({"topics": []}, "/topics: found [], must be at least one topic"),
    ],
)
def test_wrong_parameters_are_named(found, message):
    with pytest.raises(ParameterError) as error:
        read_parameters(NODE, found)
    assert str(error.value) == f"parameter {NODE}{message}"
