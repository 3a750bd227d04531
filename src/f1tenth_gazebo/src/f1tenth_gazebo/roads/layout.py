"""Draws the centreline of a road and how wide it is."""

import functools

import numpy as np

from f1tenth_gazebo.roads.features import add_chicane, add_hairpin, choose_radii, pull_to_length
from f1tenth_gazebo.roads.outline import Outline, meets_itself, rounded
from f1tenth_gazebo.roads.winding import winding_polygon
from f1tenth_gazebo.worlds.walls import THICKNESS

COARSE, FINE = 0.4, 0.1
"""Steps along the centreline, m: for a first look, and in the result."""
GREATEST_RADIUS = 6.0
"""Of the bends, m."""
_TRIES = 20
"""Attempts at each part of a road, before all of it is drawn anew."""
_WIDTH_CHANGE = 12.0
"""Distance, about, at which the width of the road changes, m."""


def draw_centreline(rng, options):
    """A Line of the wanted length that starts in the middle of its longest straight; None if this try failed.

    The start is the origin, the direction there +x.
    """
    apart = options.width[1] + 2.0 * (THICKNESS + options.raggedness)
    base = _base(rng, options, apart)
    outline = base and _with_features(rng, base, options, apart)
    if outline is None or not choose_radii(rng, outline, options.radius, GREATEST_RADIUS):
        return None
    if outline.length() > options.length:
        return None
    outline = pull_to_length(rng, outline, options.length, options.straight)
    if outline is None or _overlaps(outline, apart):
        return None
    return rounded(_from_longest_straight(outline), FINE)


def draw_widths(rng, options, line):
    """Width of the road at each sample of a centreline, m."""
    count = max(3, round(line.length / _WIDTH_CHANGE))
    places = line.length * np.arange(count) / count
    widths = rng.uniform(*options.width, size=count)
    if options.width[0] < options.width[1]:
        widths[rng.permutation(count)[:2]] = options.width
    return np.interp(line.distances, places, widths, period=line.length)


def _base(rng, options, apart):
    spacing = max(1.6 * apart, 3.5 * options.radius) * rng.uniform(1.0, 1.5)
    # What features and the longest straight add comes later.
    later = options.hairpins * 6.0 * apart + options.chicanes * 8.0 * options.radius + options.straight
    length = max(options.length * rng.uniform(0.4, 0.95) - later, 3.0 * spacing)
    for _ in range(_TRIES):
        spacing *= 1.03
        outline = Outline.of(winding_polygon(rng, spacing, length) * (1.0, rng.choice([-1.0, 1.0])))
        if _has_room(outline, options.radius, apart):
            return outline
    return None


def _with_features(rng, outline, options, apart):
    gap = (1.02 * apart, 1.02 * apart + 1.0)
    reach = (1.5 * apart, 1.5 * apart + 0.04 * options.length)
    hairpin = functools.partial(add_hairpin, rng, gap=gap, least_radius=options.radius, reach=reach)
    chicane = functools.partial(add_chicane, rng, least_radius=options.radius, width=options.width[0])
    for add in [hairpin] * options.hairpins + [chicane] * options.chicanes:
        outline = outline and _first_with_room(outline, add, options.radius, apart)
    return outline


def _first_with_room(outline, add, least_radius, apart):
    """The first of some tries to add a feature that leaves the road apart from itself, or None."""
    tried = (add(outline) for _ in range(_TRIES))
    return next((one for one in tried if _has_room(one, least_radius, apart)), None)


def _has_room(outline, least_radius, apart):
    """Whether the corners can have the least radius, and the road keeps apart from itself."""
    room = outline.greatest_radii()
    radii = np.where(np.isnan(outline.radii), np.minimum(room, GREATEST_RADIUS), outline.radii)
    enough = np.all(room >= np.maximum(least_radius, np.nan_to_num(outline.radii)) - 1e-9)
    return enough and not _overlaps(Outline(outline.points, radii, outline.kept), apart)


def _overlaps(outline, apart):
    return meets_itself(rounded(outline, COARSE), apart)


def _from_longest_straight(outline):
    """Turned, moved and begun so that the middle of the longest straight is the start."""
    edge = int(np.argmax(outline.straights()))
    tangents = outline.tangents()
    along = outline.edges()[edge] / outline.lengths()[edge]
    start = outline.points[edge] + along * (tangents[edge] + 0.5 * outline.straights()[edge])
    turn = np.array([[along[0], along[1]], [-along[1], along[0]]])
    order = np.roll(np.arange(len(outline.points)), -(edge + 1))
    points = np.concatenate([[[0.0, 0.0]], (outline.points[order] - start) @ turn.T])
    radii = np.concatenate([[1.0], outline.radii[order]])
    return Outline(points, radii, np.zeros(len(points), dtype=bool))
