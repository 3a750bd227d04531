"""A run as a picture (SVG, PNG, PDF) or as a moving one (GIF), for documents and messages."""

import itertools
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from f1tenth_sim2d.environments.ground import Ground
from f1tenth_sim2d.environments.picture import CARS, draw_moment
from matplotlib.patches import PathPatch
from matplotlib.path import Path as MatplotlibPath
from PIL import Image

from f1tenth_judge.atomic import replacing
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.record.files import REPLAY_FILE, RESULT_FILE, TRAJECTORY_FILE, read_json
from f1tenth_judge.record.record import CarTrack, Record, read_record
from f1tenth_judge.record.replay import Replay, Shape, read_replay
from f1tenth_judge.results.picture import make_figure

PICTURES, MOVING = (".svg", ".png", ".pdf"), ".gif"
_FRAME_PERIOD, _MOST_FRAMES = 0.1, 600  # s, of simulated time; longer runs are shown faster
_MARGIN = 0.5  # m
_WALL_COLOUR = "#46536a"


def export(run: Path, output: Path) -> None:
    """Draw a run, the folder of its results, into a file whose suffix says what it is.

    Raises:
        ScenarioError: another suffix, nothing was recorded, or the file cannot be written.
    """
    if output.suffix not in (*PICTURES, MOVING):
        raise ScenarioError(f"{output}: cannot be drawn; allowed: {', '.join((*PICTURES, MOVING))}")
    record, replay = read_record(run / TRAJECTORY_FILE), read_replay(run / REPLAY_FILE)
    if record.end is None:
        raise ScenarioError(f"{run}: no {TRAJECTORY_FILE} with a run to draw")
    draw = _draw_moving if output.suffix == MOVING else _draw_picture
    with writing(output), replacing(output) as temporary:
        draw(temporary, output.suffix[1:], read_json(run / RESULT_FILE), record, replay)


def _draw_picture(path: Path, kind: str, result: Mapping[str, Any], record: Record, replay: Replay) -> None:
    lines = (f"{result.get('verdict', 'unknown')}: {result.get('reason', '')}",)
    drivers = {car: each.get("planner", "") for car, each in result.get("cars", {}).items()}
    names = {car: f"{car} ({Path(planner).name})" for car, planner in drivers.items() if planner}
    figure = make_figure(result.get("scenario", ""), lines, record, {}, None, names)
    axes = figure.axes[0]
    # One path, so that the holes in walls, which turn the other way, stay free.
    outlines = [MatplotlibPath(np.array([*each, each[0]]), closed=True) for each in replay.walls.outlines]
    if outlines:
        axes.add_patch(PathPatch(MatplotlibPath.make_compound_path(*outlines), color=_WALL_COLOUR))
    left, right, bottom, top = _box(record, replay.walls)
    axes.set(xlim=(left, right), ylim=(bottom, top), facecolor="white")
    figure.savefig(path, format=kind, bbox_inches="tight", pad_inches=0.2)


def _draw_moving(path: Path, _kind: str, _result: Mapping[str, Any], record: Record, replay: Replay) -> None:
    end = float(record.end or 0.0)
    count = min(int(end / _FRAME_PERIOD) + 1, _MOST_FRAMES)
    tracks = [track for track in record.tracks.values() if len(track.time)]
    outlines = [np.array(each) for each in replay.walls.outlines]
    ground = Ground(outlines, replay.walls.circles, np.concatenate([_way(track) for track in tracks]))
    times = np.linspace(0.0, end, count)
    poses = [_poses(track, times) for track in tracks]
    frames = [
        _moment(ground, [each[index] for each in poses], [track.until(time) for track in tracks])
        for index, time in enumerate(times)
    ]
    period = round(1000 * _FRAME_PERIOD)  # ms
    frames[0].save(path, "GIF", save_all=True, append_images=frames[1:], duration=period, loop=0)


def _moment(ground: Ground, poses: Sequence[np.ndarray], driven: Sequence[CarTrack]) -> Image.Image:
    """The cars at a moment, with what they have driven."""
    return draw_moment(ground, poses, zip(itertools.cycle(CARS), map(_way, driven))).quantize(64)


def _way(track: CarTrack) -> np.ndarray:
    return np.column_stack([track.x, track.y])


def _poses(track: CarTrack, times: np.ndarray) -> np.ndarray:
    """(n, 3): x, y (m), yaw (rad) at each of n times (s)."""
    columns = (track.x, track.y, np.unwrap(track.yaw))
    return np.column_stack([np.interp(times, track.time, each) for each in columns])


def _box(record: Record, walls: Shape) -> tuple[float, float, float, float]:
    """Left, right, bottom and top of walls and ways, m."""
    tracks = [_way(track) for track in record.tracks.values()]
    circles = [np.array([[x - r, y - r], [x + r, y + r]]) for x, y, r in walls.circles]
    points = np.concatenate([*tracks, *map(np.array, walls.outlines), *circles])
    (left, bottom), (right, top) = points.min(axis=0) - _MARGIN, points.max(axis=0) + _MARGIN
    return float(left), float(right), float(bottom), float(top)
