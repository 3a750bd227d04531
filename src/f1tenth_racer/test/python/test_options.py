"""The racer's options: one table for Python, parameters and the README."""

import re
from pathlib import Path

import f1tenth_racer_core as core
import numpy as np
import pytest

README = Path(__file__).parents[2] / "README.md"
CELLS = np.zeros((9, 9), np.int8)


def shown(value):
    return str(value).lower() if isinstance(value, bool) else f"{value:.4f}"


def test_the_readme_tells_all_options_as_they_are():
    told = re.findall(
        r"^\| `(\w+)` \| (\S+) \| ([^|]*)\| ([^|]*)\| ([^|]*)\|$", README.read_text(), re.MULTILINE
    )
    for name, unit, meaning, default, allowed in core.RacerOptions.table():
        (row,) = [row for row in told if row[0] == name]
        found = row[1] if isinstance(default, bool) else f"{float(row[1]):.4f}"
        assert (found, *map(str.strip, row[2:])) == (shown(default), unit, meaning, allowed), name


def test_an_option_is_set_under_its_name():
    options = core.RacerOptions(follow_distance=1.2, unfelt_lateral_part=0.5)
    assert (options.follow_distance, options.unfelt_lateral_part) == (1.2, 0.5)
    assert core.RacerOptions().follow_distance == 0.8
    with pytest.raises(TypeError, match="unexpected option 'follow_dist'"):
        core.RacerOptions(follow_dist=1.0)


@pytest.mark.parametrize(
    ("name", "value", "allowed"),
    [
        ("follow_distance", 0.0, "a number above 0"),
        ("follow_time", -1.0, "a number of at least 0"),
        ("passing_lateral_part", 1.1, "above 0 and at most 1"),
        ("max_steering_angle", 1.6, "above 0 and below pi/2"),
    ],
)
def test_a_value_out_of_range_is_refused(name, value, allowed):
    with pytest.raises(core.OptionError, match=f"{name}: found {value:g}, must be {allowed}"):
        core.Racer(core.Costmap(CELLS, 0.05), [[0, 0, 0]], core.RacerOptions(**{name: value}))
