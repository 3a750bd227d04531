"""The fastest lap of a track, and the command that computes it."""

import math

import numpy as np
import pytest
import yaml
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.reference.car_limits import GRAVITY, Limits, read_limits
from f1tenth_judge.reference.fastest_lap import compute_fastest_lap
from f1tenth_judge.reference.track import SPACING, load_track
from f1tenth_judge.results.reference_laps import reference_laps_file

LIMITS = Limits(
    friction=1.0, max_acceleration=9.0, switch_speed=7.0, max_speed=20.0, max_curvature=1.3, mass=3.7
)


def ring(radius=5.0, half_width=0.5, count=120):
    """A circular track, counter-clockwise."""
    angle = np.arange(count) * 2 * np.pi / count
    room = np.full(count, half_width)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), room, room])


def test_the_fastest_lap_of_a_ring_is_its_inner_circle_at_the_limit_of_grip():
    lap = compute_fastest_lap(ring(), LIMITS)
    radius = 5.0 - 0.5 + LIMITS.width / 2 + LIMITS.clearance
    assert 1 / np.abs(lap.curvature) == pytest.approx(radius, rel=0.03)
    assert lap.lap_time == pytest.approx(2 * math.pi * math.sqrt(radius / GRAVITY), rel=0.02)
    assert np.all(lap.curvature > 0)
    assert math.cos(lap.yaw[0] - math.atan2(lap.y[1] - lap.y[0], lap.x[1] - lap.x[0])) > 0.99


def test_grip_is_shared_between_bends_and_braking():
    lap = compute_fastest_lap(load_track("circuit1"), LIMITS)
    across = lap.speed**2 * lap.curvature / (LIMITS.friction * GRAVITY)
    along = lap.acceleration / LIMITS.max_acceleration
    assert np.hypot(across, along).max() < 1.05
    assert np.abs(across).max() > 0.95
    assert along.min() < -0.9
    assert np.abs(lap.curvature).max() < LIMITS.max_curvature * 1.02


def test_the_laps_that_races_are_compared_with_are_those_of_today():
    shipped = yaml.safe_load(reference_laps_file().read_text(encoding="utf-8"))
    assert list(shipped) == lookup.circuits()
    # The others take a minute.
    for name in ("circuit1", "circuit_detailed"):
        lap = compute_fastest_lap(load_track(name), read_limits()).lap_time
        assert lap == pytest.approx(shipped[name], abs=0.01)


def test_points_of_a_long_track_lie_farther_apart(tmp_path):
    np.savetxt(tmp_path / "ring_centerline.csv", ring(radius=64.0), delimiter=", ")
    line = load_track(f"{tmp_path}/ring_centerline.csv")[:, :2]
    steps = np.hypot(*(np.roll(line, -1, axis=0) - line).T)
    assert steps == pytest.approx(2 * math.pi * 64.0 / 800, rel=0.01)


def test_the_track_of_a_map_is_the_centreline_beside_it(tmp_path):
    np.savetxt(tmp_path / "ring_centerline.csv", ring(), delimiter=",")
    assert np.array_equal(
        load_track(f"{tmp_path}/ring_map.yaml"), load_track(f"{tmp_path}/ring_centerline.csv")
    )


def test_a_road_too_narrow_is_refused():
    with pytest.raises(
        ScenarioError, match="no line keeps 0.05 m beside a car of 0.31 m: Problem not solvable"
    ):
        compute_fastest_lap(ring(half_width=0.18), LIMITS)


def test_without_the_package_that_computes_it_the_fastest_lap_names_it(monkeypatch):
    monkeypatch.setattr("f1tenth_judge.reference.fastest_lap.tph", None)
    with pytest.raises(ScenarioError, match="needs the Python package trajectory-planning-helpers"):
        compute_fastest_lap(ring(), LIMITS)


def test_a_circuit_is_sampled_evenly_with_its_width():
    track = load_track("circuit1")
    steps = np.hypot(*np.diff(track[:, :2], axis=0, append=track[:1, :2]).T)
    assert steps == pytest.approx(SPACING, rel=0.1)
    assert track[:, 2:] == pytest.approx(1.0)


def test_an_unknown_circuit_is_answered_with_those_there_are():
    with pytest.raises(ScenarioError, match="no circuit 'monza'; there are: circuit1, circuit2"):
        load_track("monza")
