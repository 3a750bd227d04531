"""A run as columns, in m, rad, s and m/s. Their names are the contract with `run.js`."""

from collections.abc import Mapping, Sequence
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike

from f1tenth_judge.record.record import STAMP_EPSILON, CarTrack, Record
from f1tenth_judge.record.replay import Drawing, Numbers, Replay, Shape, Timed
from f1tenth_judge.report.gaps import gaps_to_leader, way_along
from f1tenth_judge.report.packing import column, pack

_TIME, _LENGTH, _PLAN, _ANGLE, _SPEED, _FINE = 0.001, 0.01, 0.02, 0.005, 0.02, 0.001  # quanta
_WAY = 0.05  # m
_STEP, _GHOST_STEP = 0.05, 0.1  # s, between two places of a car, of this run and of the one before
_PLAN_STEP = 0.2  # s, between two plans
_GLOBAL_POINTS, _LOCAL_POINTS = 20, 8  # of a plan, at most
_DRAWN_POINTS = 20_000  # of what a topic draws, about
_STEPS = 2000  # between the least and the greatest of a planner's numbers
_GREATEST = 1e300  # of a planner's numbers: their differences are finite
_THUMBNAIL_POINTS = 50  # of a car's path, at most
_SHORT = 10.0  # m, of a path that decimetres would make a staircase
_POSE = ("x", "y", "yaw")


def pack_run(record: Record, replay: Replay) -> str:
    """Everything that a replay draws, except the walls."""
    return pack(_run(record, replay, _STEP))


def pack_world(replay: Replay) -> str:
    """What runs in the same world share: the walls."""
    return pack({"walls": _shape(replay.walls)})


def pack_tracks(record: Record, road: Sequence) -> str:
    """Only what the cars did on a road: enough for the other run of a comparison."""
    return pack(_run(record, Replay(road=road), _GHOST_STEP))


def thumbnail(record: Record) -> list[list[list[float]]]:
    """The paths of the cars, thinned, for a small drawing."""
    return [_thinned(track) for track in record.tracks.values()]


def _thinned(track: CarTrack) -> list[list[float]]:
    points = np.column_stack([track.x, track.y])[_spread(len(track.x), _THUMBNAIL_POINTS)]
    is_short = len(points) > 0 and np.ptp(points, axis=0).max() < _SHORT
    return np.round(points, 2 if is_short else 1).tolist()


def _run(record: Record, replay: Replay, step: float) -> dict[str, Any]:
    road, tracks = replay.road, record.tracks
    gaps = gaps_to_leader(record, road)
    return {
        "cars": {
            car: {
                **_track(track, step, road, gaps.get(car)),
                **_channels(track, step, replay.channels),
            }
            for car, track in tracks.items()
        },
        "road": _table(road, ("x", "y"), _LENGTH),
        "goals": [_table(goals, _POSE, _FINE) for goals in replay.goals.values()],
        "lidars": {car: column(lidar, 1e-6) for car, lidar in replay.lidars.items()},
        "bodies": {car: column(body, _FINE) for car, body in replay.bodies.items()},
        "global_plans": [_plans(paths, _GLOBAL_POINTS) for paths in replay.global_plans.values()],
        "local_plans": [_plans(paths, _LOCAL_POINTS) for paths in replay.local_plans.values()],
        "models": [
            {
                "time": column(poses.stamps, _TIME),
                "poses": _table(poses.values, _POSE, _FINE),
                "shape": _shape(poses.shape),
            }
            for poses in replay.models.values()
        ],
        "drawings": {topic: _drawings(each) for topic, each in replay.drawings.items()},
        "pictures": {
            topic: {"time": column(each.stamps, _TIME), "images": list(each.values)}
            for topic, each in replay.pictures.items()
        },
    }


def _track(
    track: CarTrack, step: float, road: Sequence, gaps: Optional[np.ndarray]
) -> dict[str, list[float]]:
    kept = _every(track.time, step)
    columns = {
        "time": column(track.time[kept], _TIME),
        "x": column(track.x[kept], _LENGTH),
        "y": column(track.y[kept], _LENGTH),
        "yaw": column(np.unwrap(track.yaw)[kept], _ANGLE),
        "speed": column(track.v_x[kept], _SPEED),
        "clearance": column(_least(track.clearance, kept), _LENGTH),
        "steering": column(track.steering_angle[kept], _ANGLE),
    }
    if len(road):
        columns["way"] = column(way_along(track.x[kept], track.y[kept], road), _WAY)
    return columns if gaps is None else {**columns, "gap": column(gaps[kept], _WAY)}


def _channels(track: CarTrack, step: float, channels: Mapping[str, Numbers]) -> dict[str, list[float]]:
    """The numbers of a car's planner, by topic, in the moments of the car."""
    times = track.time[_every(track.time, step)]
    own = {topic: each for topic, each in channels.items() if each.car == track.car and each.values}
    return {topic: _held(each, times) for topic, each in own.items()}


def _held(numbers: Numbers, times: np.ndarray) -> list[float]:
    """Each number until the next one."""
    values = np.clip(np.asarray(numbers.values, dtype=float), -_GREATEST, _GREATEST)
    last = np.searchsorted(numbers.stamps, times + STAMP_EPSILON, side="right") - 1
    span = np.ptp(values) or np.abs(values).max() or 1.0
    return column(values[last.clip(0)], max(span / _STEPS, np.abs(values).max() * 1e-12))


def _drawings(drawn: Timed) -> dict[str, Any]:
    """What a topic draws, at a rate at which it is not too much."""
    sizes = np.array([sum(map(_size, each)) for each in drawn.values])
    kept = _every(drawn.stamps, _PLAN_STEP * max(1.0, sizes.sum() / _DRAWN_POINTS))
    frames = [[pack_drawing(one) for one in drawn.values[index]] for index in kept]
    return {"time": column(np.asarray(drawn.stamps)[kept], _TIME), "frames": frames}


def _size(drawing: Drawing) -> int:
    return sum(map(len, drawing.lines)) + len(drawing.dots) + len(drawing.texts)


def pack_drawing(drawing: Drawing) -> dict[str, Any]:
    """What a planner draws at a moment."""
    return {
        "colour": drawing.colour,
        "lines": _lines(drawing.lines, _PLAN),
        "dots": _table(drawing.dots, ("x", "y", "radius"), _PLAN),
        "places": _table([each[:2] for each in drawing.texts], ("x", "y"), _PLAN),
        "texts": [text for _, _, text in drawing.texts],
    }


def _every(stamps: ArrayLike, step: float) -> np.ndarray:
    """Which of the stamps (s) are kept: the first, those a step after the one kept before, and the last."""
    times = np.asarray(stamps, dtype=float)
    if not len(times):
        return np.zeros(0, dtype=int)
    _, first = np.unique(np.floor((times - times[0]) / step + 1e-6), return_index=True)
    return np.unique(np.append(first, len(times) - 1))


def _spread(count: int, most: int) -> np.ndarray:
    """Which of `count` points are kept: the first, the last and some evenly in between."""
    return np.unique(np.linspace(0, max(count - 1, 0), most).astype(int))[:count]


def _least(values: np.ndarray, kept: np.ndarray) -> np.ndarray:
    """The least of the values since the one kept before, so that none is lost."""
    starts = np.append([0], kept[:-1] + 1)
    return np.array([values[start : end + 1].min() for start, end in zip(starts, kept)])


def _plans(paths: Timed, points: int) -> dict[str, Any]:
    kept = _every(paths.stamps, _PLAN_STEP)
    lines = [np.array(paths.values[index])[_spread(len(paths.values[index]), points)] for index in kept]
    return {"time": column(np.asarray(paths.stamps)[kept], _TIME), "lines": _lines(lines, _PLAN)}


def _shape(shape: Shape) -> dict[str, Any]:
    return {
        "outlines": _lines(shape.outlines, _FINE),
        "circles": _table(shape.circles, ("x", "y", "radius"), _FINE),
    }


def _lines(lines: Sequence[ArrayLike], quantum: float) -> list[dict[str, list[float]]]:
    return [_table(line, ("x", "y"), quantum) for line in lines]


def _table(rows: ArrayLike, names: Sequence[str], quantum: float) -> dict[str, list[float]]:
    values = np.array(rows, dtype=float).reshape(-1, len(names))
    return {name: column(values[:, index], quantum) for index, name in enumerate(names)}
