"""The Python module: a localizer in a room, and what it refuses."""

import math

import amcl_core
import numpy as np
import pytest

CELLS = np.zeros((40, 60), np.int8)
CELLS[[0, -1], :] = CELLS[:, [0, -1]] = 100
BEAMS = 361
GEOMETRY = (-math.pi, 2 * math.pi / (BEAMS - 1), 0.05, 10.0)


def localizer(cells=CELLS, start=(1.0, 1.0, 0.0), deviations=(0.1, 0.1, 0.1)):
    options = amcl_core.LocalizerOptions()
    options.laser.model = amcl_core.LaserModel.likelihood_field_prob
    options.laser.max_beams = 90
    return amcl_core.Localizer(cells, 0.1, (0.0, 0.0), options, start, deviations)


def ranges_from(x, y):
    """To the walls of the room: their inner sides are from 0.1 m to 5.9 m and 3.9 m."""
    angles = GEOMETRY[0] + GEOMETRY[1] * np.arange(BEAMS)
    with np.errstate(divide="ignore"):
        along = np.where(np.cos(angles) > 0, 5.9 - x, 0.1 - x) / np.cos(angles)
        across = np.where(np.sin(angles) > 0, 3.9 - y, 0.1 - y) / np.sin(angles)
    return np.minimum(along, across)


def test_a_car_beside_where_it_is_said_to_be_is_found():
    amcl = localizer()
    assert amcl.estimate()[0] == pytest.approx((1.0, 1.0, 0.0), abs=0.05)
    for way in np.arange(0.0, 2.0, 0.25):
        assert amcl.process(ranges_from(1.1 + way, 1.08), *GEOMETRY, (0.0, 0.0, 0.0), (way, 0.0, 0.0))
    pose, covariance = amcl.estimate()
    assert pose == pytest.approx((2.85, 1.08, 0.0), abs=0.06)
    assert covariance.shape == (3, 3)
    assert 0.0 < covariance[0, 0] < 0.01


def test_a_car_that_stands_does_not_count():
    amcl = localizer()
    arguments = (ranges_from(1.0, 1.0), *GEOMETRY, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    assert amcl.process(*arguments)
    assert not amcl.process(*arguments)


def test_a_car_that_may_be_anywhere_is_not_said_to_be_somewhere():
    amcl = localizer()
    amcl.spread_out()
    amcl.process(ranges_from(1.5, 1.2), *GEOMETRY, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    _, covariance = amcl.estimate()
    assert covariance[0, 0] + covariance[1, 1] > 1.0  # the room is the same turned around


def test_names_are_those_of_the_parameters():
    assert set(amcl_core.OdometryModel.__members__) == {"diff", "omni", "diff-corrected", "omni-corrected"}
    assert set(amcl_core.LaserModel.__members__) == {"beam", "likelihood_field", "likelihood_field_prob"}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"cells": np.zeros(4, np.int8)}, "cells: found 1 dimensions, must be 2"),
        ({"cells": np.zeros((0, 0), np.int8)}, "map"),
        ({"start": (math.nan, 0.0, 0.0)}, "nan"),
        ({"deviations": (math.inf, 0.0, 0.0)}, "covariance"),
    ],
)
def test_what_makes_no_sense_is_refused(arguments, message):
    with pytest.raises(amcl_core.Error, match=message):
        localizer(**arguments)
