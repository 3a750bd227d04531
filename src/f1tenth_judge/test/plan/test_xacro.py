"""Where the command xacro, which expands descriptions, is found."""

import shutil
import sys

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.car_description import read_description
from f1tenth_judge.scenario.car import Car


@pytest.fixture
def environment(tmp_path, monkeypatch):
    """A virtual environment that is not activated: its Python runs, its commands are not on PATH."""
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "python3").symlink_to(sys.executable)
    monkeypatch.setattr(sys, "executable", str(tmp_path / "bin" / "python3"))
    monkeypatch.setenv("PATH", str(tmp_path / "nothing"))
    return tmp_path


def described(folder):
    (folder / "car.xacro").write_text("no XML", encoding="utf-8")
    return read_description(Car("robot1", description="car.xacro"), folder)


def test_it_is_that_of_the_environment_whose_python_runs(environment):
    command = environment / "bin" / "xacro"
    command.write_text("#!/bin/sh\necho expanded by this one >&2\nexit 2\n", encoding="utf-8")
    command.chmod(0o755)
    with pytest.raises(ScenarioError, match="car.xacro: xacro: expanded by this one"):
        described(environment)


def test_a_missing_one_is_an_error_with_its_remedy(environment):
    assert shutil.which("xacro") is None
    with pytest.raises(ScenarioError, match="car.xacro: xacro is not installed: pip install xacro"):
        described(environment)
