"""The parameters, and the configuration that is shipped."""

from pathlib import Path

import yaml
from f1tenth_race_mgr.parameters import BLOCK, Parameters, goals_path
from workspace_support.nodes import parse_parameters

CONFIG = Path(__file__).resolve().parent.parent / "config"


def test_has_defaults():
    parameters = parse_parameters(Parameters)
    assert parameters == Parameters(
        use_absolute_fpath=False,
        package_name="f1tenth_race_mgr",
        fpath="/config/navigation_goals.txt",
        loop_mode=False,
        lockstep=False,
        wait_for_start=True,
        exit_when_done=False,
    )


def test_a_relative_path_is_below_the_package():
    parameters = Parameters(package_name="p", fpath="/config/goals.txt")
    assert goals_path(parameters, {"p": "/share/p"}.get) == "/share/p/config/goals.txt"


def test_an_absolute_path_needs_no_package():
    assert goals_path(Parameters(use_absolute_fpath=True, fpath="/tmp/goals.txt"), None) == "/tmp/goals.txt"


def test_the_shipped_configuration_is_the_default():
    config = yaml.safe_load((CONFIG / "race_mgr.yaml").read_text())
    assert list(config) == [BLOCK]
    assert parse_parameters(Parameters, ("race_mgr.yaml", config[BLOCK])) == Parameters()
