"""A planner in C++ on Debian's Fast DDS, which has nothing in common with the judge's Cyclone DDS."""

import shlex
import subprocess
from pathlib import Path

import pytest

SOURCE = Path(__file__).parent / "planners" / "fastdds_gap.cpp"


@pytest.fixture(scope="module")
def planner(tmp_path_factory):
    if not Path("/usr/include/fastdds/dds/topic/TopicDataType.hpp").exists():
        pytest.skip("needs Fast DDS 2 (Debian 12's libfastrtps-dev)")
    program = tmp_path_factory.mktemp("fast_dds") / "gap"
    subprocess.run(["g++", "-std=c++17", "-O1", SOURCE, "-o", program, "-lfastrtps", "-lfastcdr"], check=True)
    return program


def test_same_drive_however_scans_are_heard(race, planner):
    results = [race(shlex.join([str(planner), how])) for how in ("reliable", "best_effort", "best_effort")]
    assert {(each["verdict"], each["lockstep"]) for each in results} == {("timeout", True)}
    assert len({each["trajectory_hash"] for each in results}) == 1
