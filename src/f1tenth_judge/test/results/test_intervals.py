"""Intervals of rates and means, against published and independently computed ones."""

import pytest
from f1tenth_judge.results.intervals import Rate, change_of_mean, change_of_rate


def test_a_rate_has_wilson_s_interval():
    assert str(Rate(8, 10)) == "8 of 10 (80%; 95 % interval 49% to 94%)"


# Newcombe, Statistics in Medicine 17 (1998), table II, method 10.
@pytest.mark.parametrize(
    ("more", "less", "interval"),
    [
        ((56, 70), (48, 80), (0.0524, 0.3339)),
        ((9, 10), (3, 10), (0.1705, 0.8090)),
        ((10, 10), (0, 20), (0.6791, 1.0)),
    ],
)
def test_two_rates_differ_by_newcombe_s_interval(more, less, interval):
    change = change_of_rate(Rate(*less), Rate(*more))
    assert change[1:] == pytest.approx(interval, abs=5e-5)
    assert change_of_rate(Rate(*more), Rate(*less))[1:] == pytest.approx(
        [-interval[1], -interval[0]], abs=5e-5
    )


def test_the_same_seeds_are_compared_in_pairs():
    change = change_of_mean({1: 10.0, 2: 20.0, 3: 30.0}, {1: 10.1, 2: 20.2, 3: 30.3, 9: 5.0})
    assert change == pytest.approx((0.2, -0.0484, 0.4484), abs=1e-4)


def test_other_seeds_are_independent():
    change = change_of_mean({1: 1.0, 2: 2.0, 3: 3.0}, {4: 3.0, 5: 5.0})
    assert change == pytest.approx((2.0, -3.9770, 7.9770), abs=1e-4)
    assert change_of_mean({1: 1.0, 2: 1.0}, {3: 2.0, 4: 2.0}) == (1.0, 1.0, 1.0)


def test_one_value_has_no_interval():
    assert change_of_mean({1: 1.0}, {1: 2.0, 2: 3.0}) is None
