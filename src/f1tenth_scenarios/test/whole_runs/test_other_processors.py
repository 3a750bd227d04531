"""The same trajectory on a processor without FMA and AVX2, for which the C library has other code."""

import json
import os
import subprocess
from pathlib import Path

import pytest
from f1tenth_judge.places import lookup
from patience import PATIENCE

WITHOUT = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX512F"
PLANNER = lookup.package_path(lookup.PACKAGE) / "test" / "planners" / "nodes" / "follow_the_gap.launch"
UNPINNED = ["--set", "pinned=false"]
RUNS = {
    "alone": ["run", "circuit1", *UNPINNED],
    "two cars": ["run", "overtaking_fast", *UNPINNED],
    "amcl": ["run", "noisy_odometry_amcl", *UNPINNED],
    "turning round": ["run", "turn_around", *UNPINNED],
    "a planner that uses numpy": ["race", "circuit3", "--planner", str(PLANNER), "--interface", "f1tenth"],
}


def has_the_features():
    """Whether there is anything to go without."""
    return {"fma", "avx2"} <= set(Path("/proc/cpuinfo").read_text(encoding="ascii").split())


def hash_of(arguments, folder, **variables):
    command = ["rosrun", "f1tenth_scenarios", "scenario", *arguments, "--results", str(folder)]
    environment = {**os.environ, **variables}
    done = subprocess.run(command, capture_output=True, text=True, timeout=3 * PATIENCE, env=environment)
    assert done.returncode == 0, done.stdout
    (file,) = folder.glob("*/result.json")
    result = json.loads(file.read_text(encoding="utf-8"))
    assert result["lockstep"]
    assert result["machine"]["pinned"] is (arguments[-2:] != UNPINNED)
    return result["trajectory_hash"]


@pytest.mark.skipif(not has_the_features(), reason="a processor without FMA and AVX2")
@pytest.mark.parametrize("run", RUNS)
def test_a_processor_without_fma_and_avx2_gives_the_same_trajectory(run, tmp_path):
    here = hash_of(RUNS[run], tmp_path / "here")
    assert hash_of(RUNS[run], tmp_path / "there", GLIBC_TUNABLES=WITHOUT) == here
