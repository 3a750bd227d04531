"""The checks on the parameters, and the configuration that is shipped."""

from pathlib import Path

import pytest
import yaml
from f1tenth_race_mgr.parameters import BLOCK, ParameterError, Parameters, goals_path, parse_parameters

CONFIG = Path(__file__).resolve().parent.parent / "config"
ALLOWED = "use_absolute_fpath, package_name, fpath, loop_mode, lockstep, wait_for_start, exit_when_done"


def error_of(raw):
    with pytest.raises(ParameterError) as error:
        parse_parameters([("/robot1/race_mgr", raw)])
    return str(error.value)


def test_has_defaults():
    parameters = parse_parameters([])
    assert parameters == Parameters(
        use_absolute_fpath=False,
        package_name="f1tenth_race_mgr",
        fpath="/config/navigation_goals.txt",
        loop_mode=False,
        lockstep=False,
        wait_for_start=True,
        exit_when_done=False,
    )


def test_the_first_source_counts_most():
    sources = [("a", {"fpath": "a.txt"}), ("b", {"fpath": "b.txt", "loop_mode": True}), ("c", {})]
    parameters = parse_parameters(sources)
    assert (parameters.fpath, parameters.loop_mode) == ("a.txt", True)


def test_refuses_an_unknown_key_and_names_the_allowed_ones():
    expected = f"/robot1/race_mgr/fpaht: unknown parameter, expected one of: {ALLOWED}"
    assert error_of({"fpaht": "a.txt"}) == expected


@pytest.mark.parametrize(
    ("raw", "message"),
    [
        ({"loop_mode": "yes"}, "/robot1/race_mgr/loop_mode: expected true or false, found 'yes'"),
        ({"loop_mode": 1}, "/robot1/race_mgr/loop_mode: expected true or false, found 1"),
        ({"fpath": 5}, "/robot1/race_mgr/fpath: expected a text, found 5"),
        ({"fpath": ""}, "/robot1/race_mgr/fpath: expected a text that is not empty"),
        ("text", "/robot1/race_mgr: expected parameters by name, found 'text'"),
    ],
)
def test_refuses_wrong_types(raw, message):
    assert error_of(raw) == message


def test_a_relative_path_is_below_the_package():
    parameters = Parameters(package_name="p", fpath="/config/goals.txt")
    assert goals_path(parameters, {"p": "/share/p"}.get) == "/share/p/config/goals.txt"


def test_an_absolute_path_needs_no_package():
    assert goals_path(Parameters(use_absolute_fpath=True, fpath="/tmp/goals.txt"), None) == "/tmp/goals.txt"


def test_the_shipped_configuration_is_the_default():
    config = yaml.safe_load((CONFIG / "race_mgr.yaml").read_text())
    assert list(config) == [BLOCK]
    assert parse_parameters([("race_mgr.yaml", config[BLOCK])]) == Parameters()
