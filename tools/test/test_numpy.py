"""Modules that exchange arrays refuse a NumPy whose arrays they would misread."""

import importlib.util
import re
import subprocess
import sys
from pathlib import Path

import pytest

HEADER = Path("/usr/include/pybind11/detail/common.h")
MODULES = ["f1tenth_sim2d._f1tenth_sim2d", "workspace_support._maths", "f1tenth_racer_core"]
# The file alone, without what its package imports.
LOADING = """
import importlib.util, sys, types
name, file = sys.argv[1:]
sys.modules["numpy"] = types.ModuleType("numpy")
sys.modules["numpy"].__version__ = "2.4.6"
spec = importlib.util.spec_from_file_location(name, file)
spec.loader.exec_module(importlib.util.module_from_spec(spec))
"""


def pybind11_knows_numpy_2():
    version = re.findall(r"#define PYBIND11_VERSION_M(?:AJOR|INOR) (\d+)", HEADER.read_text())
    return tuple(map(int, version)) >= (2, 12)


@pytest.mark.skipif(not HEADER.exists(), reason="pybind11-dev is not installed: its version is not known")
@pytest.mark.parametrize("name", MODULES)
def test_numpy_2_is_refused_by_what_would_misread_it(name):
    if pybind11_knows_numpy_2():
        pytest.skip("this pybind11 reads arrays of NumPy 2")
    file = importlib.util.find_spec(name).origin
    command = [sys.executable, "-c", LOADING, name.rpartition(".")[2], file]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == (
        "ImportError: built for NumPy 1, as Debian's pybind11 is too old for NumPy 2; found NumPy 2.4.6: "
        "install 'numpy<2', or f1tenth_sim2d by pip"
    )
