"""A run as a picture (SVG, PNG, PDF) or as a moving one (GIF), for documents and messages."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.collections import PolyCollection
from PIL import Image, ImageDraw

from f1tenth_judge.atomic import replacing
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.record.files import REPLAY_FILE, RESULT_FILE, TRAJECTORY_FILE, read_json
from f1tenth_judge.record.record import CarTrack, Record, read_record
from f1tenth_judge.record.replay import Replay, Shape, read_replay
from f1tenth_judge.results.picture import CAR_COLOURS, make_figure

PICTURES, MOVING = (".svg", ".png", ".pdf"), ".gif"
_FRAME_PERIOD, _MOST_FRAMES = 0.1, 600  # s, of simulated time; longer runs are shown faster
_LONG_SIDE, _MARGIN = 640, 0.5  # px, m
_LEAST_CAR = 14  # px, of a car's length: a smaller one is drawn larger than it is
_CAR = (-0.1186, 0.4615, -0.155, 0.155)  # m: rear, front, right and left end of the F1/10 car
_ROAD_COLOUR, _WALL_COLOUR = "#fbfcfe", "#46536a"


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
    walls = PolyCollection([np.array(each) for each in replay.walls.outlines], color=_WALL_COLOUR)
    axes.add_collection(walls)
    left, right, bottom, top = _box(record, replay.walls)
    axes.set(xlim=(left, right), ylim=(bottom, top), facecolor="white")
    figure.savefig(path, format=kind, bbox_inches="tight", pad_inches=0.2)


def _draw_moving(path: Path, _kind: str, _result: Mapping[str, Any], record: Record, replay: Replay) -> None:
    end = float(record.end or 0.0)
    count = min(int(end / _FRAME_PERIOD) + 1, _MOST_FRAMES)
    camera = _Camera(_box(record, replay.walls))
    still = camera.draw_still(replay.walls)
    frames = [camera.draw_cars(still, record, time) for time in np.linspace(0.0, end, count)]
    period = round(1000 * _FRAME_PERIOD)  # ms
    frames[0].save(path, "GIF", save_all=True, append_images=frames[1:], duration=period, loop=0)


class _Camera:
    """Sees a rectangle of the map, m, from above."""

    def __init__(self, box: tuple[float, float, float, float]):
        self._left, right, bottom, self._top = box
        width, height = right - self._left, self._top - bottom
        self._scale = _LONG_SIDE / max(width, height)
        self._size = (round(width * self._scale), round(height * self._scale))

    def draw_still(self, walls: Shape) -> Image.Image:
        """What does not move."""
        image = Image.new("RGB", self._size, _ROAD_COLOUR)
        draw = ImageDraw.Draw(image)
        for outline in walls.outlines:
            draw.polygon(self._pixels(np.array(outline)), fill=_WALL_COLOUR)
        for x, y, radius in walls.circles:
            corners = np.array([[x - radius, y + radius], [x + radius, y - radius]])
            draw.ellipse(self._pixels(corners), fill=_WALL_COLOUR)
        return image

    def draw_cars(self, still: Image.Image, record: Record, time: float) -> Image.Image:
        """A moment (s), with the ways of the cars so far."""
        image = still.copy()
        draw = ImageDraw.Draw(image)
        for number, track in enumerate(record.tracks.values()):
            colour = CAR_COLOURS[number % len(CAR_COLOURS)]
            driven = track.until(time)
            if len(driven.time) > 1:
                draw.line(self._pixels(np.column_stack([driven.x, driven.y])), fill=colour, width=2)
            draw.polygon(self._pixels(self._corners(track, time)), fill=colour, outline="white")
        return image.quantize(64)

    def _corners(self, track: CarTrack, time: float) -> np.ndarray:
        rear, front, right, left = np.array(_CAR) * max(1.0, _LEAST_CAR / (self._scale * (_CAR[1] - _CAR[0])))
        yaw = np.interp(time, track.time, np.unwrap(track.yaw))
        turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
        place = [np.interp(time, track.time, values) for values in (track.x, track.y)]
        return np.array([(rear, right), (front, right), (front, left), (rear, left)]) @ turn.T + place

    def _pixels(self, points: np.ndarray) -> list[tuple[float, float]]:
        return [((x - self._left) * self._scale, (self._top - y) * self._scale) for x, y in points.tolist()]


def _box(record: Record, walls: Shape) -> tuple[float, float, float, float]:
    """Left, right, bottom and top of walls and ways, m."""
    tracks = [np.column_stack([track.x, track.y]) for track in record.tracks.values()]
    circles = [np.array([[x - r, y - r], [x + r, y + r]]) for x, y, r in walls.circles]
    points = np.concatenate([*tracks, *map(np.array, walls.outlines), *circles])
    (left, bottom), (right, top) = points.min(axis=0) - _MARGIN, points.max(axis=0) + _MARGIN
    return float(left), float(right), float(bottom), float(top)
