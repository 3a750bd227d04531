import dataclasses
import os
import platform
import subprocess
import sys
from pathlib import Path

import pytest
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.pins import is_pinned, machine, variables_of
from f1tenth_judge.plan.source import read_scenario

SCENARIO = read_scenario(lookup.scenario_file("circuit1"))
X86 = pytest.mark.skipif(platform.machine() != "x86_64", reason="glibc has one variant only")

PLANNER = """
import hashlib, math, random
import numpy as np
places = [random.Random(1).uniform(-9.0, 9.0) * i for i in range(100000)]
values = [math.sin(x) + math.atan2(x, 3.0) + math.exp(math.cos(x)) for x in places]
array = np.array(places)
values += (np.exp(np.sin(array)) + np.arctan2(array, 3.0)).tolist()
matrix = array[:90000].reshape(300, 300)
values += (matrix @ matrix).ravel().tolist()
print(hashlib.sha256(np.array(values).tobytes()).hexdigest())
"""


def hash_with(variables):
    environment = {**os.environ, **variables}
    return subprocess.check_output([sys.executable, "-W", "error", "-c", PLANNER], env=environment, text=True)


@X86
def test_math_and_numpy_give_the_same_bits_whatever_the_processor_has():
    less = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX512F"
    pinned = variables_of(SCENARIO, {})
    assert hash_with(pinned) == hash_with(variables_of(SCENARIO, {"GLIBC_TUNABLES": less}))


@X86
def test_tunables_of_the_user_stay():
    found = variables_of(SCENARIO, {"GLIBC_TUNABLES": "glibc.malloc.check=3"})["GLIBC_TUNABLES"]
    assert found.startswith("glibc.malloc.check=3:glibc.cpu.hwcaps=")


@pytest.mark.parametrize("change", [{"lockstep": False}, {"pinned": False}])
def test_nothing_is_pinned_without_lockstep_or_when_it_is_not_wanted(change):
    scenario = dataclasses.replace(SCENARIO, **change)
    assert variables_of(scenario, {}) == {}
    assert not is_pinned(scenario)


def test_results_say_what_computed_them():
    found = machine(SCENARIO)
    assert found["architecture"] == platform.machine()
    assert found["libc"] == " ".join(platform.libc_ver())
    assert found["pinned"] is is_pinned(SCENARIO)
    assert set(found["features"]) <= set(Path("/proc/cpuinfo").read_text(encoding="ascii").split())
