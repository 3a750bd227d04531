"""What tools/check_mathematics refuses and what it lets pass."""

import importlib.machinery
import importlib.util
from pathlib import Path

import pytest

TOOL = Path(__file__).resolve().parents[1] / "check_mathematics"


def _load():
    loader = importlib.machinery.SourceFileLoader("check_mathematics", str(TOOL))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


tool = _load()


@pytest.mark.parametrize(
    "line",
    [
        "x = std::sin(yaw);",
        "x = sin(yaw);",
        "x = 2.0*sinf (yaw);",
        "T t = ceres::atan2(y, x);",
        "double d = std::hypot(x, y);",
        "std::normal_distribution<double> noise(0.0, 1.0);",
        "std::shuffle(begin, end, random);",
        "Eigen::Rotation2Dd turn(yaw);",
        "double yaw = tf2::getYaw(q);",
        "q.setRPY(0.0, 0.0, yaw);",
    ],
)
def test_the_c_librarys_functions_are_refused_in_cpp(line):
    assert [number for number, _ in tool.faults_of_cpp(f"int a;\n{line}\n")] == [2]


@pytest.mark.parametrize(
    "line",
    [
        "x = maths::sin(yaw);",
        "x = std::sqrt(y) + std::remainder(y, 2.0) + std::floor(y);",
        "// std::sin(x) is not used",
        'error("std::sin(x)");',
        "environment.log();",
        "void Environment::log()",
        "double angle() const { return slope_.tan(x); }",
    ],
)
def test_exact_functions_own_ones_and_text_pass_in_cpp(line):
    assert list(tool.faults_of_cpp(line)) == []


@pytest.mark.parametrize(
    "text",
    [
        "import math\nmath.sin(1.0)",
        "\nfrom math import pi, cos",
        "import numpy as np\nnp.arctan2(y, x)",
        "import numpy as np\nnp.linalg.norm(x)",
        "\na @ b",
        "\nx**2",
        "import random\nrandom.Random(1).gauss(0.0, 1.0)",
        "\nfrom scipy import interpolate",
    ],
)
def test_functions_that_differ_are_refused_in_python(text):
    assert [number for number, _ in tool.faults_of_python(text)] == [2]


@pytest.mark.parametrize(
    "text",
    [
        "import math\nmath.sqrt(2.0) + math.pi",
        "from workspace_support import maths\nmaths.sin(1.0)",
        "LIMIT = 2**31 - 1",
        "import numpy as np\nnp.sqrt(np.minimum(x, y))",
        "# math.sin(1.0)",
    ],
)
def test_exact_functions_and_own_ones_pass_in_python(text):
    assert tool.faults_of_python(text) == []


def test_guarded_folders_exist_and_their_tests_are_free():
    assert all((tool.WORKSPACE / folder).is_dir() for folder in [*tool.GUARDED, *tool.OWN])
    assert tool.is_guarded("src/f1tenth_sim2d/src/core/car/car.cpp")
    assert not tool.is_guarded("src/sim2d_lockstep/test/a.cpp")
    assert not tool.is_guarded("src/workspace_support/include/workspace_support/maths/trigonometry.h")


def test_a_fault_is_told_with_its_place(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(tool, "WORKSPACE", tmp_path)
    monkeypatch.setattr(tool.sys, "argv", ["check_mathematics", str(tmp_path / "src/sim2d_lockstep/a.cpp")])
    folder = tmp_path / "src/sim2d_lockstep"
    folder.mkdir(parents=True)
    (folder / "a.cpp").write_text("\ndouble x = std::exp(1.0);\n")
    assert tool.main() == 1
    expected = (
        "src/sim2d_lockstep/a.cpp:2: std::exp: differs between processors; use workspace_support's maths\n"
    )
    assert capsys.readouterr().out == expected
