"""Races of planners on DDS."""

import psutil
import pytest
from f1tenth_judge.drivers.ros2.driver import ros2_drivers
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.run.execute import execute
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.stop_request import StopRequest
from result_schema import valid_result


def environment_of(process):
    try:
        return str(process.environ())
    except psutil.Error:  # it has ended
        return ""


@pytest.fixture
def race(tmp_path):
    """Lets planners race on circuit1; returns what result.json says."""

    def run(*commands, settings=()):
        planners = [Driver(ros2=each) for each in commands]
        plan = plan_race(Race("circuit1", 1, planners), tmp_path, ["limits.timeout=5", *settings])
        execute(plan, ros2_drivers, StopRequest())
        assert not [each for each in psutil.process_iter() if str(tmp_path) in environment_of(each)]
        return valid_result(tmp_path / "result.json")

    return run
