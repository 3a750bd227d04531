"""The picture of a run: its paths over the map, with starts, goals and contacts."""

import itertools
import textwrap
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Optional

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from f1tenth_judge.atomic import replacing
from f1tenth_judge.places.map_file import FREE, OCCUPIED, Grid
from f1tenth_judge.record.record import CarTrack, Record
from f1tenth_judge.scenario.car import Pose

_MARGIN = 1.0  # m, around what is drawn
_LONG_SIDE = 11.0  # inch
_DOTS_PER_INCH = 130
_CHARACTERS_PER_INCH = 13  # of the text, about
_LEGEND_HEIGHT = 20  # points
_NAME_DISTANCE = 0.045  # from where a car starts, of the longer side of what is drawn
_CONTACT_COLOUR = "#d62728"
CAR_COLOURS = ("#2f5bea", "#e0582b", "#12957a", "#9333ea")  # as in report.css
_GOAL_COLOUR = "#1f3b57"
_GOAL_SIZE = 13.0  # points, with a number in it
_SMALL_GOAL_SIZE = 4.0  # points
_NUMBERED = (1, 5, 10, 50, 100)  # n, if every n-th goal has its number


def write_picture(
    path: Path,
    title: str,
    lines: Sequence[str],
    record: Record,
    goals: Mapping[str, Sequence[Pose]],
    track_map: Optional[Grid],
    names: Optional[Mapping[str, str]] = None,
) -> None:
    """Draw a run into a PNG file, which replaces the old one when it is complete.

    The lines are below the title; the map, if there is one, is beneath the run; names are the cars' for the
    legend.
    """
    figure = make_figure(title, lines, record, goals, track_map, names)
    with replacing(path) as temporary, warnings.catch_warnings():
        # What is quoted of a node may be in any script, of which the font has not every character.
        warnings.filterwarnings("ignore", "Glyph .* missing")
        figure.savefig(temporary, dpi=_DOTS_PER_INCH, bbox_inches="tight", pad_inches=0.2)


def make_figure(title, lines, record, goals, track_map, names=None) -> Figure:
    """The drawing; arguments as of write_picture."""
    tracks = [track for track in record.tracks.values() if len(track.time)]
    box = _bounding_box(tracks, goals, track_map)
    figure = Figure(figsize=_figure_size(box))
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    _draw_map(axes, track_map)
    if len(tracks) > 1:
        _draw_race(axes, tracks, names or {})
    elif tracks:
        _draw_path(figure, axes, tracks[0])
    _draw_goals(axes, goals, 72.0 * _inches_per_metre(box))
    _draw_contacts(axes, tracks)
    _name_cars(axes, tracks, goals, box)
    _finish(figure, axes, box, title, lines)
    return figure


def _bounding_box(tracks, goals, track_map):
    """Left, right, bottom, top of all that matters: walls, paths and goals; not the map's empty border."""
    xs = [track.x for track in tracks] + [np.array([goal.x for goal in poses]) for poses in goals.values()]
    ys = [track.y for track in tracks] + [np.array([goal.y for goal in poses]) for poses in goals.values()]
    if track_map is not None:
        wall_xs, wall_ys = _wall_extremes(track_map)
        xs.append(wall_xs)
        ys.append(wall_ys)
    x, y = (np.concatenate([*values, np.zeros(1)]) for values in (xs, ys))
    return x.min() - _MARGIN, x.max() + _MARGIN, y.min() - _MARGIN, y.max() + _MARGIN


def _wall_extremes(track_map):
    rows, columns = np.nonzero(track_map.cells == OCCUPIED)
    if not len(rows):
        return np.empty(0), np.empty(0)
    x = track_map.x + track_map.resolution * np.array([columns.min(), columns.max() + 1])
    y = track_map.y + track_map.resolution * np.array([rows.min(), rows.max() + 1])
    return x, y


def _figure_size(box):
    width, height = box[1] - box[0], box[3] - box[2]
    scale = _inches_per_metre(box)
    return max(width * scale, 6.0) + 1.4, max(height * scale, 3.5) + 0.9


def _inches_per_metre(box):
    return _LONG_SIDE / max(box[1] - box[0], box[3] - box[2])


def _draw_map(axes, track_map):
    if track_map is None:
        return
    # Walls dark, free space white, unknown light: a map's own greys are too heavy behind a coloured path.
    shades = np.select([track_map.cells == OCCUPIED, track_map.cells == FREE], [0.25, 1.0], default=0.93)
    place = {"origin": "lower", "extent": track_map.extent, "zorder": 0}
    axes.imshow(shades, cmap="gray", vmin=0, vmax=1, interpolation="nearest", **place)


def _draw_path(figure, axes, track: CarTrack) -> None:
    """A single path, coloured by speed."""
    scale = matplotlib.colors.Normalize(0.0, max(float(track.speed.max()), 0.1))
    lines = _path_lines(track, scale)
    axes.add_collection(lines)
    _draw_start(axes, track, "#2ca02c", "start")
    bar = figure.colorbar(lines, ax=axes, fraction=0.046, pad=0.02, shrink=0.85)
    bar.set_label("speed (m/s)")
    bar.outline.set_visible(False)


def _draw_race(axes, tracks: Sequence[CarTrack], names: Mapping[str, str]) -> None:
    """The paths of several cars, a colour for each."""
    for track, colour in zip(tracks, itertools.cycle(CAR_COLOURS)):
        name = names.get(track.car, track.car)
        axes.plot(track.x, track.y, color=colour, linewidth=1.8, alpha=0.85, zorder=3, label=name)
        _draw_start(axes, track, colour, None)


def _draw_start(axes, track: CarTrack, colour: str, label: Optional[str]) -> None:
    axes.plot(
        track.x[0],
        track.y[0],
        marker=(3, 0, np.degrees(track.yaw[0]) - 90),
        markersize=11,
        color=colour,
        markeredgecolor="white",
        linestyle="none",
        zorder=5,
        label=label,
    )


def _name_cars(axes, tracks: Sequence[CarTrack], goals, box) -> None:
    """Write each car's name beside its start, where it hides neither paths nor goals."""
    drawn = [np.column_stack([track.x, track.y]) for track in tracks]
    drawn += [np.array([(goal.x, goal.y) for goal in poses]) for poses in goals.values() if poses]
    distance = _NAME_DISTANCE * max(box[1] - box[0], box[3] - box[2])
    for track in tracks:
        start = np.array([track.x[0], track.y[0]])
        axes.annotate(
            track.car,
            start,
            xytext=free_place(start, distance, np.concatenate(drawn)),
            fontsize=8,
            ha="center",
            va="center",
            zorder=6,
            bbox={"boxstyle": "round,pad=0.25", "facecolor": "white", "edgecolor": "none", "alpha": 0.85},
            arrowprops={"arrowstyle": "-", "color": "#888888", "linewidth": 0.8},
        )


def free_place(start: np.ndarray, distance: float, drawn: np.ndarray) -> np.ndarray:
    """The place at a distance (m) from a start that is farthest from what is drawn, of shape (n, 2)."""
    angles = np.radians(np.arange(0, 360, 30))
    places = start + distance * np.column_stack([np.cos(angles), np.sin(angles)])
    room = [np.hypot(*(drawn - place).T).min() for place in places]
    return places[int(np.argmax(room))]


def _path_lines(track: CarTrack, scale) -> LineCollection:
    points = np.column_stack([track.x, track.y])[:, None, :]
    lines = LineCollection(
        np.concatenate([points[:-1], points[1:]], axis=1),
        cmap="plasma",
        norm=scale,
        linewidths=2.4,
        capstyle="round",
        zorder=3,
    )
    lines.set_array((track.speed[:-1] + track.speed[1:]) / 2)
    return lines


def _draw_goals(axes, goals, points_per_metre):
    drawn = set()
    for poses in goals.values():
        step = numbering_step(poses, points_per_metre)
        for number, goal in enumerate(poses, start=1):
            if (goal.x, goal.y) in drawn:
                continue
            is_numbered = number % step == 0
            axes.plot(
                goal.x,
                goal.y,
                "o",
                markersize=_GOAL_SIZE if is_numbered else _SMALL_GOAL_SIZE,
                color=_GOAL_COLOUR,
                markeredgecolor="white",
                alpha=0.85,
                zorder=4,
                label=None if drawn else "goals",
            )
            if is_numbered:
                _write_number(axes, number, goal)
            drawn.add((goal.x, goal.y))


def numbering_step(goals: Sequence[Pose], points_per_metre: float) -> int:
    """The n with which every n-th goal can have its number and the path between them stays visible."""
    if len(goals) < 2:
        return 1
    places = np.array([(goal.x, goal.y) for goal in goals])
    gap = float(np.median(np.hypot(*np.diff(places, axis=0).T))) * points_per_metre
    return next((step for step in _NUMBERED if step * gap >= 3.0 * _GOAL_SIZE), _NUMBERED[-1])


def _write_number(axes, number: int, goal: Pose) -> None:
    axes.annotate(
        str(number),
        (goal.x, goal.y),
        color="white",
        fontsize=7.5,
        fontweight="bold",
        ha="center",
        va="center_baseline",
        zorder=5,
    )


def _draw_contacts(axes, tracks):
    contacts = [contact for track in tracks for contact in track.contact_list()]
    if contacts:
        axes.plot(
            [contact.x for contact in contacts],
            [contact.y for contact in contacts],
            "X",
            markersize=13,
            color=_CONTACT_COLOUR,
            markeredgecolor="white",
            linestyle="none",
            zorder=7,
            label="contact",
        )


def _finish(figure, axes, box, title, lines):
    axes.set(xlim=box[:2], ylim=box[2:], aspect="equal", xlabel="x (m)", ylabel="y (m)")
    axes.set_facecolor("#ededed")
    axes.grid(color="black", alpha=0.07, linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    width = int(figure.get_size_inches()[0] * _CHARACTERS_PER_INCH)
    text = "\n".join(part for line in lines for part in textwrap.wrap(line, width))
    height = _LEGEND_HEIGHT + 13 * (text.count("\n") + 1)  # points
    axes.set_title(title, fontsize=14, fontweight="bold", loc="left", pad=height + 10, parse_math=False)
    axes.annotate(
        text,
        (0, 1),
        (0, 6 + _LEGEND_HEIGHT),
        "axes fraction",
        "offset points",
        fontsize=9.5,
        color="#444444",
        parse_math=False,
    )
    if axes.get_legend_handles_labels()[0]:
        axes.legend(
            loc="lower left",
            bbox_to_anchor=(0.0, 1.0),
            borderaxespad=0.1,
            borderpad=0.2,
            ncols=4,
            fontsize=8.5,
            frameon=False,
            markerscale=0.75,
        )
