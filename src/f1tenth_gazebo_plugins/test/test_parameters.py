import pytest
from f1tenth_gazebo_plugins.parameters import ParameterError, Parameters, parse_parameters

NODE = "/robot1/collision_detection"


def test_defaults_are_the_four_bumpers_and_the_ground():
    assert parse_parameters(NODE, None) == Parameters(
        topics=("bumper_front", "bumper_rear", "bumper_left", "bumper_right"), ground_models=("ground_plane",)
    )


def test_reads_what_is_there():
    found = {"topics": ["a", "b"], "ground_models": []}
    assert parse_parameters(NODE, found) == Parameters(topics=("a", "b"), ground_models=())


@pytest.mark.parametrize(
    ("found", "message"),
    [
        ({"topic": []}, "/topic: unknown; allowed: topics, ground_models"),
        ({"topics": "a"}, "/topics: found 'a', expected a list of names"),
        ({"topics": []}, "/topics: found [], expected at least one topic"),
        ({"topics": ["a", 1]}, "/topics[1]: found 1, expected a name"),
        ({"ground_models": [""]}, "/ground_models[0]: found '', expected a name"),
        ({"topics": ["a", "a"]}, "/topics: found ['a', 'a'], expected different names"),
        (3, ": found 3, expected a map"),
    ],
)
def test_wrong_parameters_are_named(found, message):
    with pytest.raises(ParameterError) as error:
        parse_parameters(NODE, found)
    assert str(error.value) == f"parameter {NODE}{message}"
