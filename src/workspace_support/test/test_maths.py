import math

import numpy as np
import pytest

from workspace_support import maths

PLACES = np.random.default_rng(1).uniform(-1.0, 1.0, 200)
UNARY = ["sin", "cos", "tan", "asin", "acos", "atan", "exp", "log"]
BINARY = ["atan2", "hypot"]


@pytest.mark.parametrize("name", UNARY)
def test_a_function_of_a_number_is_that_of_math_and_its_array_that_of_its_numbers(name):
    places = abs(PLACES) if name == "log" else PLACES
    values = [getattr(maths, name)(float(x)) for x in places]
    assert all(type(value) is float for value in values)
    assert values == pytest.approx([getattr(math, name)(x) for x in places], rel=5e-16, abs=5e-16)
    assert getattr(maths, name)(places).tolist() == values


@pytest.mark.parametrize("name", BINARY)
def test_a_function_of_two_numbers_takes_arrays_and_numbers(name):
    values = getattr(maths, name)(PLACES, 0.5)
    assert values.tolist() == [getattr(maths, name)(y, 0.5) for y in PLACES]
    assert values == pytest.approx([getattr(math, name)(y, 0.5) for y in PLACES], rel=5e-16)


def test_powers_and_roots():
    assert maths.cbrt(-27.0) == pytest.approx(-3.0, rel=1e-15)
    assert maths.pow(2.0, 0.5) == pytest.approx(math.sqrt(2.0), rel=1e-15)
    assert math.isnan(maths.pow(-2.0, 0.5))


def test_what_has_no_result_is_nan():
    assert math.isnan(maths.asin(2.0))
    assert math.isnan(maths.log(-1.0))
