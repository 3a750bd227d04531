"""A run as columns, in m, rad, s and m/s. Their names are the contract with `run.js`."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from f1tenth_scenarios.record.record import CarTrack, Record
from f1tenth_scenarios.record.replay import Paths, Replay, Shape
from f1tenth_scenarios.report.gaps import gaps_to_leader
from f1tenth_scenarios.report.packing import Packer

_TIME, _LENGTH, _PLAN, _ANGLE, _SPEED, _FINE = 0.001, 0.01, 0.02, 0.005, 0.02, 0.001  # quanta
_STEP, _GHOST_STEP = 0.05, 0.1  # s, between two places of a car, of this run and of the one before
_PLAN_STEP = 0.2  # s, between two plans
_PLAN_POINTS = {"global": 20, "local": 8}  # of a plan, at most
_THUMBNAIL_POINTS = 50  # of a car's path, at most


def pack_run(record: Record, replay: Replay) -> str:
    """Everything that a replay draws, but the walls."""
    packer = Packer()
    _add_tracks(packer, record, _STEP, gaps_to_leader(record, replay.road))
    for car, goals in replay.goals.items():
        _add_poses(packer, f"goals/{car}", goals)
    for car, lidar in replay.lidars.items():
        packer.add(f"lidars/{car}", lidar, 1e-6)
    for car, body in replay.bodies.items():
        packer.add(f"bodies/{car}", body, _FINE)
    for kind, plans in (("global", replay.global_plans), ("local", replay.local_plans)):
        for car, paths in plans.items():
            _add_plans(packer, f"plans/{kind}/{car}", paths, _PLAN_POINTS[kind])
    for name, poses in replay.models.items():
        packer.add(f"models/{name}/time", poses.stamps, _TIME)
        _add_poses(packer, f"models/{name}", poses.values)
        _add_shape(packer, f"models/{name}", poses.shape)
    return packer.pack()


def pack_world(replay: Replay) -> str:
    """What runs in the same world share: the walls."""
    packer = Packer()
    _add_shape(packer, "walls", replay.walls)
    return packer.pack()


def pack_tracks(record: Record) -> str:
    """Only what the cars did: enough for the other run of a comparison."""
    packer = Packer()
    _add_tracks(packer, record, _GHOST_STEP, {})
    return packer.pack()


def thumbnail(record: Record) -> list[list[list[float]]]:
    """The paths of the cars, thinned, for a drawing as large as a thumb."""
    return [_thinned(track) for track in record.tracks.values()]


def _thinned(track: CarTrack) -> list[list[float]]:
    chosen = np.unique(np.linspace(0, len(track.time) - 1, _THUMBNAIL_POINTS).astype(int))
    return np.round(np.column_stack([track.x, track.y])[chosen], 1).tolist()


def _add_tracks(packer, record: Record, step: float, gaps: Mapping[str, np.ndarray]) -> None:
    for car, track in record.tracks.items():
        kept = _every(track.time, step)
        packer.add(f"cars/{car}/time", track.time[kept], _TIME)
        packer.add(f"cars/{car}/x", track.x[kept], _LENGTH, order=2)
        packer.add(f"cars/{car}/y", track.y[kept], _LENGTH, order=2)
        packer.add(f"cars/{car}/yaw", np.unwrap(track.yaw)[kept], _ANGLE)
        packer.add(f"cars/{car}/speed", track.v_x[kept], _SPEED)
        packer.add(f"cars/{car}/clearance", _least(track.clearance, kept), _LENGTH)
        packer.add(f"cars/{car}/steering", track.steering_angle[kept], _ANGLE)
        if car in gaps:
            packer.add(f"cars/{car}/gap", gaps[car][kept], 0.05)


def _every(stamps: ArrayLike, step: float) -> np.ndarray:
    """Which of the stamps (s) are kept: the first, those a step after the one kept before, and the last."""
    times = np.asarray(stamps, dtype=float)
    if not len(times):
        return np.zeros(0, dtype=int)
    _, first = np.unique(np.floor((times - times[0]) / step + 1e-6), return_index=True)
    return np.unique(np.append(first, len(times) - 1))


def _least(values: np.ndarray, kept: np.ndarray) -> np.ndarray:
    """The least of the values since the one kept before, so that none is lost."""
    starts = np.append([0], kept[:-1] + 1)
    return np.array([values[start : end + 1].min() for start, end in zip(starts, kept)])


def _add_poses(packer, name: str, poses: Sequence) -> None:
    table = np.array(poses, dtype=float).reshape(-1, 3)
    for column, quantity in enumerate(("x", "y", "yaw")):
        packer.add(f"{name}/{quantity}", table[:, column], _FINE)


def _add_plans(packer, name: str, paths: Paths, points: int) -> None:
    kept = _every(paths.stamps, _PLAN_STEP)
    packer.add(f"{name}/time", np.asarray(paths.stamps)[kept], _TIME)
    _add_lines(packer, name, [_few(paths.values[index], points) for index in kept], _PLAN, order=2)


def _few(line: Sequence, most: int) -> Sequence:
    chosen = np.unique(np.linspace(0, len(line) - 1, most).astype(int)) if len(line) else []
    return [line[index] for index in chosen]


def _add_shape(packer, name: str, shape: Shape) -> None:
    _add_lines(packer, f"{name}/outlines", shape.outlines, _FINE, order=1)
    packer.add(f"{name}/circles", np.array(shape.circles, dtype=float), _FINE, 3)


def _add_lines(packer, name: str, lines: Sequence, quantum: float, order: int) -> None:
    table = np.array([point for line in lines for point in line], dtype=float).reshape(-1, 2)
    packer.add(f"{name}/length", [len(line) for line in lines], 1)
    packer.add(f"{name}/x", table[:, 0], quantum, order=order)
    packer.add(f"{name}/y", table[:, 1], quantum, order=order)
