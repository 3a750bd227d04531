"""A car that drives around once must leave a map that agrees with the world."""

import contextlib
import os
import signal
import subprocess

import numpy as np
import pytest
from f1tenth_gazebo.maps.map_tool import main
from f1tenth_judge.places.map_file import Grid, load_map, save_map
from ports import free_port
from shipped import NAMES, PACKAGE

# One circuit at every run of the tests; F1TENTH_ALL_MAPS=1 makes all of them.
CIRCUITS = NAMES if os.environ.get("F1TENTH_ALL_MAPS") else ["circuit1"]


@contextlib.contextmanager
def launched(name, stem, *arguments):
    """A launch that makes the map of a world, and its environment."""
    port = str(free_port())
    given = [f"world_file_name:={name}", "drive:=auto", "seed:=1", f"map_file:={stem}"]
    command = ["roslaunch", "-p", port, "f1tenth_gazebo", "create_map.launch", *given, *arguments]
    environment = {**os.environ, "ROS_MASTER_URI": f"http://localhost:{port}"}
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, env=environment, stdout=pipe, stderr=subprocess.STDOUT, text=True)
    try:
        yield process, environment
    finally:
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
            process.wait()


@pytest.mark.parametrize(
    ("name", "lockstep"), [*((name, "true") for name in CIRCUITS), (CIRCUITS[0], "false")]
)
def test_map_agrees_with_its_world(name, lockstep, tmp_path, capsys):
    stem = os.path.join(os.environ.get("F1TENTH_PICTURES", str(tmp_path)), name)
    with launched(name, stem, f"lockstep:={lockstep}") as (process, _):
        output = process.communicate(timeout=600)[0]
    # roslaunch says in red that a required node has died.
    assert "REQUIRED" not in output, output
    code = main(PACKAGE, [f"{stem}.yaml", name])
    assert code == 0, capsys.readouterr().out


def test_interrupted_drive_leaves_what_has_been_mapped(tmp_path):
    stem = tmp_path / "part"
    with launched("circuit1", stem, "lockstep:=true") as (process, environment):
        # It ends when there is a first map.
        saver = ["rosrun", "map_server", "map_saver", "-f", str(tmp_path / "first")]
        subprocess.run(saver, env=environment, timeout=120, check=True, capture_output=True)
        process.send_signal(signal.SIGINT)
        output = process.communicate(timeout=120)[0]
    assert "drive_lap: interrupted after" in output
    assert (load_map(tmp_path / "part.yaml").pixels == 254).any()


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("image: [", ":1: not YAML: end of sequence flow not found"),
        ("<sdf/>", ": not a map description, allowed are lines 'key: value'"),
    ],
)
def test_file_that_is_no_map_is_refused_in_one_line(tmp_path, capsys, text, problem):
    path = tmp_path / "a.yaml"
    path.write_text(text)
    world = str(PACKAGE / "worlds" / "circuit1.world")
    assert main(PACKAGE, [str(path), world]) == 2
    assert capsys.readouterr().err == f"{path}{problem}\n"


def test_missing_file_is_named(tmp_path, capsys):
    path, image = tmp_path / "a.yaml", tmp_path / "a.pgm"
    command = [str(path), str(PACKAGE / "worlds" / "circuit1.world")]
    assert main(PACKAGE, command) == 2
    assert capsys.readouterr().err == f"{path}: no such file, or it cannot be read\n"
    save_map(Grid(np.zeros((1, 1), np.uint8), 0.0, 0.0), tmp_path / "a")
    image.unlink()
    assert main(PACKAGE, command) == 2
    assert capsys.readouterr().err == f"{image}: no such file, or it cannot be read\n"
