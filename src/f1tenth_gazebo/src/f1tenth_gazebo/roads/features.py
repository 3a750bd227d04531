"""What turns a polygon into a road: hairpins, chicanes, straights, the wanted length."""

import math

import numpy as np
from scipy.optimize import brentq

_TRIES = 40
_CHICANE_TURN = (math.radians(25.0), math.radians(50.0))


def add_hairpin(rng, outline, gap, least_radius, reach):
    """The outline with a finger on one edge: out, half a circle, back beside the way out.

    Args:
        gap: (least, greatest) distance between the ways out and back, m.
        least_radius: of the bends, m.
        reach: (least, greatest) length of the finger, m.
    """
    gap = max(rng.uniform(*gap), 2.0 * least_radius)
    foot = 2.0 * least_radius + 0.1
    outline, edge = _with_long_edge(rng, outline, gap + 2.0 * foot)
    start, along, aside, room = _frame(rng, outline, edge, gap + 2.0 * foot)
    reach = max(rng.uniform(*reach), 2.0 * foot, gap + 0.2)
    at = rng.uniform(0.0, room) + foot
    corners = [(at, 0.0), (at, reach), (at + gap, reach), (at + gap, 0.0)]
    points = np.array([start + x * along + y * aside for x, y in corners])
    radii = np.array([np.nan, gap / 2.0, gap / 2.0, np.nan])
    return outline.spliced(edge, points, radii, np.array([False, True, True, True, False]))


def add_chicane(rng, outline, least_radius, width):
    """The outline with a step aside and back on one edge."""
    offset = rng.uniform(0.6, 1.2) * max(width, 3.0 * least_radius)
    turn = rng.uniform(*_CHICANE_TURN)
    step, pause = offset / math.tan(turn), rng.uniform(1.0, 1.6) * 2.0 * least_radius * math.tan(turn / 2)
    pause = max(pause, 0.5)
    end = 2.0 * least_radius
    needed = 2.0 * step + pause + 2.0 * end
    outline, edge = _with_long_edge(rng, outline, needed)
    start, along, aside, room = _frame(rng, outline, edge, needed)
    at = rng.uniform(0.0, room) + end
    corners = [(at, 0.0), (at + step, offset), (at + step + pause, offset), (at + 2.0 * step + pause, 0.0)]
    points = np.array([start + x * along + y * aside for x, y in corners])
    return outline.spliced(edge, points, np.full(4, np.nan), np.array([False, True, True, True, False]))


def choose_radii(rng, outline, least, greatest):
    """Draw the radii that are not chosen yet. Returns whether every corner had room for the least one."""
    room = outline.greatest_radii()
    free = np.isnan(outline.radii)
    draw = rng.uniform(size=len(room))
    high = np.clip(room, least, greatest)
    outline.radii = np.where(free, least * (high / least) ** draw, outline.radii)
    return bool(np.all(room >= outline.radii - 1e-9))


def pull_to_length(rng, outline, length, straight):
    """Pull the outline apart until its longest straight and its whole length are as wanted. Or None."""
    main = int(np.argmax(np.where(outline.kept, 0.0, outline.straights())))
    missing = straight - outline.straights()[main]
    if missing > 0.0:
        outline = _pulled(outline, main, missing)
    for _ in range(_TRIES):
        missing = length - outline.length()
        if missing < 1e-6:
            break
        room = np.where(outline.kept, 0.0, straight - outline.straights())
        edge = int(rng.choice(len(room), p=_shares(np.maximum(room, 0.0) ** 2)))
        most = room[edge] * rng.uniform(0.5, 1.0)
        outline = _pulled_towards(outline, edge, most, length)
    # Edges that run alongside have grown as well.
    fits = abs(length - outline.length()) < 1e-3 and np.max(outline.straights()) < 1.05 * straight + 0.1
    return outline if fits and np.all(outline.greatest_radii() >= outline.radii - 1e-9) else None


def _pulled_towards(outline, edge, most, length):
    """The outline, pulled by at most `most` m, and no longer than `length`."""
    if _pulled(outline, edge, most).length() <= length:
        return _pulled(outline, edge, most)
    amount = brentq(lambda amount: _pulled(outline, edge, amount).length() - length, 0.0, most, xtol=1e-9)
    return _pulled(outline, edge, amount)


def _pulled(outline, edge, amount):
    """All that lies beyond the middle of an edge is moved along it. Kept edges stay on one side, whole."""
    direction = outline.edges()[edge] / outline.lengths()[edge]
    middle = outline.points[edge] + 0.5 * outline.edges()[edge]
    beyond = (outline.points - middle) @ direction > 0.0
    for _ in range(len(beyond)):
        beyond = beyond | (outline.kept & np.roll(beyond, -1)) | np.roll(outline.kept & beyond, 1)
    beyond[edge], beyond[(edge + 1) % len(beyond)] = False, True
    moved = outline.points + np.where(beyond[:, np.newaxis], amount * direction, 0.0)
    return type(outline)(moved, outline.radii, outline.kept)


def _with_long_edge(rng, outline, length):
    """The outline, pulled so that one of its free edges is at least that long, and that edge."""
    edge = int(rng.choice(np.flatnonzero(~outline.kept)))
    missing = length - outline.lengths()[edge]
    return (_pulled(outline, edge, missing + 1e-6) if missing > 0.0 else outline), edge


def _frame(rng, outline, edge, length):
    """Start of an edge, the directions along and to one side of it, and what a feature leaves of it, m."""
    along = outline.edges()[edge] / outline.lengths()[edge]
    aside = rng.choice([-1.0, 1.0]) * np.array([-along[1], along[0]])
    return outline.points[edge], along, aside, outline.lengths()[edge] - length


def _shares(weights):
    total = weights.sum()
    return weights / total if total > 0.0 else np.full(len(weights), 1.0 / len(weights))
