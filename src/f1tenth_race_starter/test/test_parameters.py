"""The checks on the parameters."""

import pytest
from f1tenth_race_starter.parameters import ParameterError, Parameters, parse_parameters

WHOLE_NUMBER = "expected a whole number of seconds from 0 to 2147483647, found"


def test_has_defaults():
    assert parse_parameters({}, "/race_starter") == Parameters(time_to_start=5, lockstep=False, linger=5.0)


def test_takes_what_is_given():
    raw = {"time_to_start": 0, "lockstep": True, "linger": 2}
    assert parse_parameters(raw, "/race_starter") == Parameters(0, True, 2)


@pytest.mark.parametrize(
    ("raw", "message"),
    [
        ({"time_to_start": -1}, f"/n/time_to_start: {WHOLE_NUMBER} -1"),
        ({"time_to_start": 1.5}, f"/n/time_to_start: {WHOLE_NUMBER} 1.5"),
        ({"time_to_start": 5.0}, f"/n/time_to_start: {WHOLE_NUMBER} 5.0"),
        ({"time_to_start": True}, f"/n/time_to_start: {WHOLE_NUMBER} True"),
        ({"time_to_start": "soon"}, f"/n/time_to_start: {WHOLE_NUMBER} 'soon'"),
        ({"time_to_start": 2**31}, f"/n/time_to_start: {WHOLE_NUMBER} 2147483648"),
        ({"lockstep": 1}, "/n/lockstep: expected true or false, found 1"),
        ({"linger": -1.0}, "/n/linger: expected a number of seconds, 0 or more, found -1.0"),
        ({"linger": float("nan")}, "/n/linger: expected a number of seconds, 0 or more, found nan"),
        ({"linger": False}, "/n/linger: expected a number of seconds, 0 or more, found False"),
        ({"tim": 5}, "/n/tim: unknown parameter, expected one of: time_to_start, lockstep, linger"),
    ],
)
def test_refuses_in_one_line(raw, message):
    with pytest.raises(ParameterError) as error:
        parse_parameters(raw, "/n")
    assert str(error.value) == message
