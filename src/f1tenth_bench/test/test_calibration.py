import math
from dataclasses import astuple

import pytest
from f1tenth_bench.benchmark import Benchmark, Measured
from f1tenth_bench.calibration import REFERENCE, Calibration, calibrate
from f1tenth_bench.report import Result


def test_reference_machine_has_slowness_one():
    assert REFERENCE.slowness() == 1.0
    assert REFERENCE.slowness(of_messages=True) == 1.0


def test_slowness_is_the_mean_of_calculating_or_that_of_messages():
    slower = Calibration(2.0 * REFERENCE.arithmetic_s, 8.0 * REFERENCE.memory_s, 3.0 * REFERENCE.messages_s)
    assert slower.slowness() == pytest.approx(4.0)
    assert slower.slowness(of_messages=True) == pytest.approx(3.0)


def test_best_of_two_calibrations_takes_the_lesser_of_each_time():
    assert Calibration(1.0, 4.0, 6.0).at_best(Calibration(2.0, 3.0, 5.0)) == Calibration(1.0, 3.0, 5.0)


def test_calibration_measures_all_kinds_of_work():
    measured = calibrate()
    for seconds in astuple(measured):
        assert 0.0 < seconds < math.inf


@pytest.mark.parametrize(
    ("bound", "slowness", "limit"),
    [
        ({"at_least": 100.0}, 2.0, 50.0),
        ({"at_most": 100.0}, 2.0, 200.0),
        ({"at_most": 100.0}, 0.5, 50.0),
        ({"at_most": 1.5, "is_ratio": True}, 2.0, 1.5),
    ],
)
def test_limit_follows_the_machine_unless_it_is_one_of_a_ratio(bound, slowness, limit):
    benchmark = Benchmark("key", "x", lambda: Measured(1.0), **bound)
    assert benchmark.limit(slowness) == limit
    assert Result(benchmark, Measured(limit), slowness).ok
    beyond = limit * (0.99 if "at_least" in bound else 1.01)
    assert not Result(benchmark, Measured(beyond), slowness).ok
