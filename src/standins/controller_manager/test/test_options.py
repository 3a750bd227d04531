import os
import subprocess
import sys
from pathlib import Path

import pytest
from controller_manager.command_line import manager_parser, run_manager, spawner_parser, unspawner_parser

LONG = 60.0  # wall s: only a hang takes that long


def test_spawner_starts_and_waits_half_a_minute_by_default():
    options = spawner_parser().parse_args(["a", "b"])
    assert (options.controllers, options.stopped, options.timeout) == (["a", "b"], False, 30.0)


def test_spawner_understands_the_options_of_the_original():
    arguments = [
        "--stopped",
        "--wait-for",
        "/go",
        "--namespace",
        "/car",
        "--no-timeout",
        "--shutdown-timeout",
        "3",
        "a",
    ]
    options = spawner_parser().parse_args(arguments)
    assert (options.stopped, options.wait_for, options.namespace) == (True, "/go", "/car")
    assert (options.timeout, options.shutdown_timeout) == (None, 3.0)


@pytest.mark.parametrize("parser", [spawner_parser, unspawner_parser])
def test_a_controller_must_be_named(parser, capsys):
    with pytest.raises(SystemExit) as ended:
        parser().parse_args([])
    assert ended.value.code == 2
    assert "CONTROLLER" in capsys.readouterr().err


def test_unknown_command_names_the_known_ones(capsys):
    with pytest.raises(SystemExit):
        manager_parser().parse_args(["restart"])
    # Python 3.12 and later list them without quotes.
    assert "list, list-types" in capsys.readouterr().err.replace("'", "")


def test_command_without_controller_is_refused(capsys):
    with pytest.raises(SystemExit):
        run_manager(["load"])
    assert "load: name at least one controller" in capsys.readouterr().err


@pytest.mark.parametrize("command", ["controller_manager", "spawner", "unspawner"])
def test_help_needs_no_master(command):
    script = Path(__file__).parents[1] / "scripts" / command
    done = subprocess.run(
        [sys.executable, str(script), "--help"],
        env={**os.environ, "ROS_MASTER_URI": "http://localhost:1"},
        capture_output=True,
        text=True,
        timeout=LONG,
    )
    assert done.returncode == 0
    assert done.stdout.startswith(f"usage: {command} [-h]")
