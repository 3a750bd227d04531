"""Islands on a road, and the line that leads around them."""

from dataclasses import replace

import numpy as np

from f1tenth_gazebo.roads.road_options import ISLAND_RADII, MIN_WIDTH

_STRAIGHT = 4.0
"""Around an island the road bends with at least this radius, m."""
_REACH = 4.0
"""How far before an island the line begins to turn aside, and how far behind it is back, m."""
_START = 6.0
"""The least distance of an island from the start, m."""
_TRIES = 60


def place_islands(rng, line, widths, options):
    """Islands on the right and on the left of the line, and how the line leaves the centreline for them.

    Returns:
        ((islands on the right, islands on the left), offsets to the left at each sample, m); islands are
        (x, y, radius) in m. None if there is no place for as many as are wanted.
    """
    offsets = np.zeros(len(line.points))
    islands, taken = ([], []), []
    for _ in range(_TRIES):
        if len(taken) == options.islands:
            break
        i = int(rng.integers(len(line.points)))
        radius = rng.uniform(*ISLAND_RADII)
        # The island is on either side, the passage on the other.
        side, room = rng.choice([-1.0, 1.0]), widths[i] - MIN_WIDTH - 2.0 * radius
        if room < 0.0 or not _is_free(line, i, taken):
            continue
        aside = side * (MIN_WIDTH + radius - 0.5 * widths[i] + rng.uniform(0.0, room + radius))
        x, y = line.points[i] + aside * line.normals()[i]
        islands[int(side > 0.0)].append((float(x), float(y), float(radius)))
        taken.append(line.distances[i])
        passage_middle = 0.5 * (aside - side * (radius + 0.5 * widths[i]))
        offsets += passage_middle * _bump(line, line.distances[i])
    return (islands, offsets) if len(taken) == options.islands else None


def around(line, offsets):
    """The Line that leads around the islands."""
    points = line.points + offsets[:, np.newaxis] * line.normals()
    steps = np.roll(points, -1, axis=0) - points
    lengths = np.hypot(*steps.T)
    distances = np.concatenate([[0.0], np.cumsum(lengths)])
    between = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    turns = np.remainder(between - np.roll(between, 1) + np.pi, 2.0 * np.pi) - np.pi
    return replace(
        line,
        points=points,
        headings=between - 0.5 * turns,
        curvatures=turns / (0.5 * (lengths + np.roll(lengths, 1))),
        distances=distances[:-1],
        length=float(distances[-1]),
    )


def _is_free(line, i, taken):
    far = _along(line, line.distances[i])
    others = [min(abs(far_), line.length - abs(far_)) for far_ in line.distances[i] - np.array([0.0, *taken])]
    near = np.abs(far) < _REACH + 1.0
    least = [_START] + [2.0 * _REACH] * len(taken)
    return bool(np.all(np.array(others) > least) and np.max(np.abs(line.curvatures[near])) < 1.0 / _STRAIGHT)


def _bump(line, place):
    """1 beside the island, 0 before and behind it, even in between."""
    far = np.clip(np.abs(_along(line, place)) / _REACH, 0.0, 1.0)
    return 0.5 * (1.0 + np.cos(np.pi * far))


def _along(line, place):
    """From a place to each sample, the shorter way around, m."""
    return np.remainder(line.distances - place + 0.5 * line.length, line.length) - 0.5 * line.length
