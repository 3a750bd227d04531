"""The command must work in every spelling that launch files and people use."""

import os
import subprocess
import sys

import pytest
from roslaunch.config import load_config_default
from roslaunch.core import RLException

MACRO_FILE = """<?xml version="1.0"?>
<robot name="car" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left"/>
  <xacro:macro name="wheel" params="side"><link name="${side}_wheel"/></xacro:macro>
  <xacro:wheel side="$(arg side)"/>
</robot>
"""


@pytest.fixture
def macro_file(tmp_path):
    path = tmp_path / "car.urdf.xacro"
    path.write_text(MACRO_FILE)
    return path


def run(*command, **keywords):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False, **keywords)


def test_rosrun_expands_macros_with_the_default_argument(macro_file):
    result = run("rosrun", "xacro", "xacro", macro_file)
    assert result.returncode == 0, result.stderr
    assert '<link name="left_wheel"/>' in result.stdout


def test_rosrun_takes_arguments_and_an_output_file(macro_file, tmp_path):
    output = tmp_path / "car.urdf"
    result = run("rosrun", "xacro", "xacro", macro_file, "side:=right", "-o", output)
    assert result.returncode == 0, result.stderr
    assert '<link name="right_wheel"/>' in output.read_text()


def test_command_is_on_the_path(macro_file):
    assert "left_wheel" in run("xacro", macro_file).stdout


def load_launch_file(tmp_path, arguments):
    launch_file = tmp_path / "car.launch"
    launch_file.write_text(
        f"""<launch><param name="robot_description" command="$(find xacro)/xacro {arguments}"/></launch>"""
    )
    return load_config_default([str(launch_file)], port=None, verbose=False)


def test_launch_file_finds_the_command(macro_file, tmp_path):
    config = load_launch_file(tmp_path, f"'{macro_file}' side:=right")
    assert "right_wheel" in config.params["/robot_description"].value


def test_launch_file_with_a_wrong_macro_file_fails(tmp_path):
    with pytest.raises(RLException, match="no/such.xacro"):
        load_launch_file(tmp_path, "/no/such.xacro")


def test_missing_module_is_one_clear_line(macro_file):
    script = run("catkin_find", "--first-only", "--libexec", "xacro", "xacro").stdout.strip()
    # -S leaves out site-packages, -I the environment: what remains is the standard library.
    result = run(sys.executable, "-S", "-I", script, macro_file, env={"PATH": os.environ["PATH"]})
    assert result.returncode == 1
    assert result.stderr.count("\n") == 1
    assert result.stderr.startswith("xacro: the Python module 'xacro' is missing")
    assert "pip install --break-system-packages xacro==1.13.3" in result.stderr
