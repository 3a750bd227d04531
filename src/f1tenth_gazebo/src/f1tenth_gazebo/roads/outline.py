"""A road's centreline as a polygon whose corners are rounded off."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

_RATIO = 2.0
"""Two places nearer to each other than the road is wide may belong to one bend: then the way between them is
at most this many times that width."""


@dataclass
class Outline:
    """A closed polygon in driving order, m."""

    points: np.ndarray
    """Shape (n, 2)."""
    radii: np.ndarray
    """Of the corners, m, shape (n,); nan: not yet chosen."""
    kept: np.ndarray
    """Whether the edge that begins at the corner keeps its length and its place among its neighbours."""

    @staticmethod
    def of(points):
        """An outline whose corners are free."""
        return Outline(np.array(points), np.full(len(points), np.nan), np.zeros(len(points), dtype=bool))

    def edges(self):
        """From each corner to the next, m: shape (n, 2)."""
        return np.roll(self.points, -1, axis=0) - self.points

    def lengths(self):
        """Of the edges, m."""
        return np.hypot(*self.edges().T)

    def turns(self):
        """At the corners, rad, left is positive."""
        edges = self.edges()
        headings = np.arctan2(edges[:, 1], edges[:, 0])
        return np.remainder(headings - np.roll(headings, 1) + np.pi, 2.0 * np.pi) - np.pi

    def greatest_radii(self):
        """The radii with which each bend takes half of the shorter edge at its corner, m."""
        lengths = self.lengths()
        room = 0.5 * np.minimum(lengths, np.roll(lengths, 1))
        return room / np.maximum(np.tan(0.5 * np.abs(self.turns())), 1e-9)

    def tangents(self):
        """How much of each edge goes into the bend at its corner, m."""
        return self.radii * np.tan(0.5 * np.abs(self.turns()))

    def straights(self):
        """What the bends leave of the edges, m."""
        tangents = self.tangents()
        return self.lengths() - tangents - np.roll(tangents, -1)

    def length(self):
        """Of the rounded line, m."""
        return float(np.sum(self.straights()) + np.sum(self.radii * np.abs(self.turns())))

    def spliced(self, edge, points, radii, kept):
        """With further corners on an edge; `kept` is for it and the edges that follow the new corners."""
        at = edge + 1
        return Outline(
            np.concatenate([self.points[:at], points, self.points[at:]]),
            np.concatenate([self.radii[:at], radii, self.radii[at:]]),
            np.concatenate([self.kept[:edge], kept, self.kept[at:]]),
        )


@dataclass(frozen=True)
class Line:
    """A closed line by samples about evenly spaced, the first of them not repeated at the end."""

    points: np.ndarray
    """m, shape (n, 2)."""
    headings: np.ndarray
    """rad, shape (n,)."""
    curvatures: np.ndarray
    """1/m, left is positive, shape (n,)."""
    distances: np.ndarray
    """From the first sample along the line, m, shape (n,)."""
    length: float
    """m"""

    def normals(self):
        """To the left, shape (n, 2)."""
        return np.column_stack([-np.sin(self.headings), np.cos(self.headings)])


def rounded(outline, step):
    """The Line of an outline whose radii are all chosen, with samples at most `step` m apart."""
    parts = []
    turns, tangents, straights = outline.turns(), outline.tangents(), outline.straights()
    edges = outline.edges() / outline.lengths()[:, np.newaxis]
    for i, corner in enumerate(outline.points):
        heading = math.atan2(edges[i - 1, 1], edges[i - 1, 0])
        start = corner - tangents[i] * edges[i - 1]
        parts.append(_piece(start, heading, turns[i], outline.radii[i] * abs(turns[i]), step))
        parts.append(_piece(corner + tangents[i] * edges[i], heading + turns[i], 0.0, straights[i], step))
    points, headings, curvatures, steps = (np.concatenate(column) for column in zip(*parts))
    distances = np.concatenate([[0.0], np.cumsum(steps)])
    return Line(points, headings, curvatures, distances[:-1], float(distances[-1]))


def _piece(start, heading, turn, length, step):
    """Points, headings, curvatures and steps of an arc or a straight, its end left out."""
    count = math.ceil(length / step) if length > 1e-9 else 0
    along = length * np.arange(count) / max(count, 1)
    curvature = turn / length if count else 0.0
    # The chord from the start to each point: exact for arcs, and for straights as sinc is 1 at 0.
    chord = along * np.sinc(0.5 * curvature * along / np.pi)
    direction = heading + 0.5 * curvature * along
    points = start + chord[:, np.newaxis] * np.column_stack([np.cos(direction), np.sin(direction)])
    return (
        points,
        heading + curvature * along,
        np.full(count, curvature),
        np.full(count, length / max(count, 1)),
    )


def meets_itself(line, apart):
    """Whether the line comes nearer to itself than two roads side by side are apart, walls included, m."""
    a, b = cKDTree(line.points).query_pairs(apart, output_type="ndarray").T
    near = np.hypot(*(line.points[a] - line.points[b]).T) < 0.99 * apart
    between = np.abs(line.distances[a] - line.distances[b])
    between = np.minimum(between, line.length - between)
    return bool(np.any(near & (between > _RATIO * apart)))
