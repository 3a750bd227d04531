"""The checks on the parameters of nodes, and publishers that send at once."""

import warnings
from dataclasses import dataclass

import pytest
from workspace_support.nodes import ParameterError, parse_parameters, synchronous_publisher

WHOLE_NUMBER = "must be a whole number from 0 to 2147483647"
NUMBER = "must be a number >= 0"


@dataclass(frozen=True)
class Parameters:
    count: int = 5
    lockstep: bool = False
    seconds: float = 5.0
    path: str = "here"
    topics: tuple = ("a",)


def test_what_is_not_given_has_its_default():
    assert parse_parameters(Parameters) == parse_parameters(Parameters, ("/n", {})) == Parameters()


def test_takes_what_is_given():
    given = {"count": 0, "lockstep": True, "seconds": 0, "path": "there", "topics": ["b", "c"]}
    assert parse_parameters(Parameters, ("/n", given)) == Parameters(0, True, 0.0, "there", ("b", "c"))
    given = {"count": 2**31 - 1, "topics": []}
    assert parse_parameters(Parameters, ("/n", given)) == Parameters(count=2**31 - 1, topics=())


def test_the_first_source_counts_most():
    sources = [("a", {"path": "a.txt"}), ("b", {"path": "b.txt", "lockstep": True}), ("c", {})]
    assert parse_parameters(Parameters, *sources) == Parameters(path="a.txt", lockstep=True)


@pytest.mark.parametrize(
    ("found", "message"),
    [
        ({"count": -1}, f"/count: found -1, {WHOLE_NUMBER}"),
        ({"count": 1.5}, f"/count: found 1.5, {WHOLE_NUMBER}"),
        ({"count": 5.0}, f"/count: found 5.0, {WHOLE_NUMBER}"),
        ({"count": True}, f"/count: found True, {WHOLE_NUMBER}"),
        ({"count": "soon"}, f"/count: found 'soon', {WHOLE_NUMBER}"),
        ({"count": 2**31}, f"/count: found 2147483648, {WHOLE_NUMBER}"),
        ({"lockstep": 1}, "/lockstep: found 1, must be true or false"),
        ({"lockstep": "yes"}, "/lockstep: found 'yes', must be true or false"),
        ({"seconds": -1.0}, f"/seconds: found -1.0, {NUMBER}"),
        ({"seconds": float("nan")}, f"/seconds: found nan, {NUMBER}"),
        ({"seconds": float("inf")}, f"/seconds: found inf, {NUMBER}"),
        ({"seconds": False}, f"/seconds: found False, {NUMBER}"),
        ({"path": 5}, "/path: found 5, must be a text that is not empty"),
        ({"path": ""}, "/path: found '', must be a text that is not empty"),
        ({"topics": "a"}, "/topics: found 'a', must be a list of names"),
        ({"topics": ["a", 1]}, "/topics[1]: found 1, must be a name"),
        ({"topics": [""]}, "/topics[0]: found '', must be a name"),
        ({"topics": ["a", "b", "a"]}, "/topics[2]: found 'a' twice, must be a different name"),
        ({"coun": 5}, "/coun: unknown; allowed: count, lockstep, seconds, path, topics"),
        ("text", ": found 'text', must be a map"),
    ],
)
def test_refuses_in_one_line(found, message):
    with pytest.raises(ParameterError) as error:
        parse_parameters(Parameters, ("/n", found))
    assert str(error.value) == f"parameter /n{message}"


def test_publisher_has_no_queue_and_warns_of_nothing(monkeypatch):
    made = []

    def publisher(*arguments, **options):
        # As rospy does.
        warnings.warn("should be created with 'queue_size'", SyntaxWarning, stacklevel=2)
        made.append((arguments, options))
        return "a publisher"

    monkeypatch.setattr("rospy.Publisher", publisher)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert synchronous_publisher("topic", str, latch=True) == "a publisher"
    assert made == [(("topic", str), {"queue_size": None, "tcp_nodelay": True, "latch": True})]


def test_publisher_hides_no_other_warning(monkeypatch):
    def publisher(*_, **__):
        warnings.warn("old", DeprecationWarning, stacklevel=2)

    monkeypatch.setattr("rospy.Publisher", publisher)
    with pytest.warns(DeprecationWarning, match="^old$"):
        synchronous_publisher("topic", str)
