"""The parameters, and the configuration that is shipped."""

from pathlib import Path

import pytest
import yaml
from f1tenth_race_mgr.node import BadInputError, load_goals, read_parameters
from f1tenth_race_mgr.parameters import BLOCK, Parameters, goals_path
from workspace_support.nodes import parse_parameters

from f1tenth_race_mgr import node

NODE, BESIDE = "/robot1/race_mgr", f"/robot1/{BLOCK}"
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


@pytest.fixture
def server(monkeypatch):
    """The parameters by their names; those of the node itself are below NODE."""
    tree = {}
    monkeypatch.setattr(node.rospy, "get_name", lambda: NODE)
    monkeypatch.setattr(node.rospy, "resolve_name", lambda name: f"/robot1/{name}")
    monkeypatch.setattr(
        node.rospy, "get_param", lambda name, default: tree.get(name.replace("~", NODE), default)
    )
    return tree


def test_private_parameters_come_before_the_block_below_the_node_and_that_before_the_one_beside_it(server):
    server[BESIDE] = {"fpath": "/beside", "package_name": "beside", "loop_mode": True}
    server[NODE] = {"fpath": "/private", BLOCK: {"fpath": "/below", "package_name": "below"}}
    found = read_parameters()
    assert (found.fpath, found.package_name, found.loop_mode) == ("/private", "below", True)


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        (NODE, {"loop": True}, f"{NODE}/loop: unknown; allowed: use_absolute_fpath, "),
        (NODE, {BLOCK: {"a": 1}}, f"{NODE}/{BLOCK}/a: unknown"),
        (BESIDE, {"looop_mode": True}, f"{BESIDE}/looop_mode: unknown;"),
        (NODE, 5, f"{NODE}: found 5, must be a map"),
    ],
)
def test_wrong_parameters_are_named_with_their_place(server, name, value, message):
    server[name] = value
    with pytest.raises(BadInputError, match=message):
        read_parameters()


def test_package_that_is_not_there_is_named():
    class Navigation:
        def load_goals(self, path):
            raise AssertionError(path)

    with pytest.raises(BadInputError, match="^package_name: no package 'no_such_package'$"):
        load_goals(Navigation(), Parameters(package_name="no_such_package"))
