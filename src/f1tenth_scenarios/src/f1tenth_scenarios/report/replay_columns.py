"""A run as columns, in m, rad, s and m/s. Their names are the contract with `run.js`."""

from collections.abc import Sequence

import numpy as np

from f1tenth_scenarios.record.record import CarTrack, Record
from f1tenth_scenarios.record.replay import Paths, Replay, Shape
from f1tenth_scenarios.report.packing import Packed, Packer

_TIME, _LENGTH, _ANGLE, _SPEED, _RANGE = 0.001, 0.001, 0.001, 0.01, 0.04  # quanta


def pack_run(record: Record, replay: Replay) -> Packed:
    """Everything that a replay draws."""
    packer = Packer()
    _add_tracks(packer, record)
    _add_shape(packer, "walls", replay.walls)
    for car, goals in replay.goals.items():
        _add_poses(packer, f"goals/{car}", goals)
    for car, scans in replay.scans.items():
        packer.add(f"scans/{car}/time", scans.stamps, _TIME)
        packer.add(f"scans/{car}/fan", [scans.angle_min, scans.angle_max, *scans.mount], 1e-6)
        ranges = np.array(scans.values, dtype=float) / 100
        packer.add(f"scans/{car}/ranges", ranges, _RANGE, ranges.shape[1] if ranges.ndim == 2 else 1)
    for kind, plans in (("global", replay.global_plans), ("local", replay.local_plans)):
        for car, paths in plans.items():
            _add_paths(packer, f"plans/{kind}/{car}", paths)
    for name, poses in replay.models.items():
        packer.add(f"models/{name}/time", poses.stamps, _TIME)
        _add_poses(packer, f"models/{name}", poses.values)
        _add_shape(packer, f"models/{name}", poses.shape)
    return packer.pack()


def pack_tracks(record: Record) -> Packed:
    """Only what the cars did: enough for the other run of a comparison."""
    packer = Packer()
    _add_tracks(packer, record)
    return packer.pack()


def thumbnail(record: Record, points: int = 70) -> list[list[list[float]]]:
    """The paths of the cars, thinned, for a drawing as large as a thumb."""
    return [_thinned(track, points) for track in record.tracks.values()]


def _thinned(track: CarTrack, points: int) -> list[list[float]]:
    chosen = np.unique(np.linspace(0, len(track.time) - 1, points).astype(int))
    return np.round(np.column_stack([track.x, track.y])[chosen], 2).tolist()


def _add_tracks(packer, record):
    for car, track in record.tracks.items():
        packer.add(f"cars/{car}/time", track.time, _TIME)
        packer.add(f"cars/{car}/x", track.x, _LENGTH)
        packer.add(f"cars/{car}/y", track.y, _LENGTH)
        packer.add(f"cars/{car}/yaw", np.unwrap(track.yaw), _ANGLE)
        packer.add(f"cars/{car}/speed", track.v_x, _SPEED)
        packer.add(f"cars/{car}/clearance", track.clearance, _LENGTH)
        packer.add(f"cars/{car}/steering", track.steering_angle, _ANGLE)


def _add_poses(packer, name: str, poses: Sequence) -> None:
    table = np.array(poses, dtype=float).reshape(-1, 3)
    for column, quantity in enumerate(("x", "y", "yaw")):
        packer.add(f"{name}/{quantity}", table[:, column], _LENGTH)


def _add_paths(packer, name: str, paths: Paths) -> None:
    packer.add(f"{name}/time", paths.stamps, _TIME)
    _add_lines(packer, name, paths.values)


def _add_shape(packer, name: str, shape: Shape) -> None:
    _add_lines(packer, f"{name}/outlines", shape.outlines)
    packer.add(f"{name}/circles", np.array(shape.circles, dtype=float), _LENGTH, 3)


def _add_lines(packer, name: str, lines: Sequence) -> None:
    table = np.array([point for line in lines for point in line], dtype=float).reshape(-1, 2)
    packer.add(f"{name}/length", [len(line) for line in lines], 1)
    packer.add(f"{name}/x", table[:, 0], _LENGTH)
    packer.add(f"{name}/y", table[:, 1], _LENGTH)
