"""Criteria of what surrounds the driving: localization, odometry and computing time."""

import operator

import numpy as np

from f1tenth_judge.judge.criterion import Criterion, Measured, compared, status_of
from f1tenth_judge.judge.judge import Judgement
from f1tenth_judge.scenario.scenario import Scenario


def localization_error(scenario: Scenario, judgement: Judgement, measured: Measured) -> Criterion:
    """Root mean square of the distance between estimate and truth, of the worst car."""
    errors = [np.hypot(each[:, 0], each[:, 1]) for each in _errors(judgement, measured)]
    return _error_criterion(scenario, "localization_error", errors, "m")


def localization_yaw_error(scenario: Scenario, judgement: Judgement, measured: Measured) -> Criterion:
    """The same of the heading."""
    errors = [np.abs(each[:, 2]) for each in _errors(judgement, measured)]
    return _error_criterion(scenario, "localization_yaw_error", errors, "rad")


def odometry_drift(scenario: Scenario, judgement: Judgement, measured: Measured) -> Criterion:
    """How far from the truth the odometry ends, as a share of the way, of the worst car."""
    tracks = judgement.record.tracks
    drifts = [
        _drift(tracks[car], poses)
        for car, poses in measured.estimates.items()
        if car in tracks and len(poses.stamps) > 1
    ]
    shares = [(distance / way, distance, way) for distance, way in drifts if way > 0]
    worst = max(shares, default=None)
    text = "{1:.3f} m after {2:.1f} m"
    return compared(
        scenario, "odometry_drift", operator.le, worst, "", text, "no odometry (visual_odom) was heard"
    )


def real_time_factor(scenario: Scenario, _judgement: Judgement, measured: Measured) -> Criterion:
    """Whether the run was as fast as asked for."""
    actual, limit = measured.real_time_factor, scenario.criteria.real_time_factor
    text = "too short to measure" if actual is None else f"{actual:.1f} simulated seconds per second"
    met = actual is not None and limit is not None and actual >= limit
    return Criterion("real_time_factor", status_of(met), actual, limit, "", text)


def _error_criterion(scenario, name, errors, unit):
    """`errors`: of each car, at each of its estimates."""
    worst = None
    if errors:
        worst = max(float(np.sqrt(np.mean(np.square(each)))) for each in errors), max(map(np.max, errors))
    text = f"{{:.3f}} {unit} (RMS), {{:.3f}} {unit} at most"
    return compared(scenario, name, operator.le, worst, unit, text, "no estimate (amcl_pose) was heard")


def _errors(judgement: Judgement, measured: Measured) -> list[np.ndarray]:
    """Per car, rows of x (m), y (m) and yaw (rad): estimate minus truth at the estimate's stamp."""
    tracks = judgement.record.tracks
    return [
        _differences(tracks[car], poses)
        for car, poses in measured.estimates.items()
        if car in tracks and poses.stamps
    ]


def _drift(track, poses):
    """Distance from the truth at the end, with both begun at one pose, and the way; m."""
    estimate, truth = np.array(poses.values, dtype=float), _truth(track, poses.stamps)
    turn = truth[0, 2] - estimate[0, 2]
    cosine, sine = np.cos(turn), np.sin(turn)
    led_to = truth[0, :2] + np.array([[cosine, -sine], [sine, cosine]]) @ (estimate[-1] - estimate[0])[:2]
    way = np.hypot(*np.diff(truth[:, :2], axis=0).T).sum()
    return float(np.hypot(*(led_to - truth[-1, :2]))), float(way)


def _truth(track, stamps):
    return np.column_stack(
        [np.interp(stamps, track.time, values) for values in (track.x, track.y, np.unwrap(track.yaw))]
    )


def _differences(track, poses):
    estimate, truth = np.array(poses.values, dtype=float), _truth(track, poses.stamps)
    difference = estimate - truth
    difference[:, 2] = (difference[:, 2] + np.pi) % (2 * np.pi) - np.pi
    return difference
