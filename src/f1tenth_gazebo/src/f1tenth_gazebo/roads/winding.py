"""A winding closed polygon: the outline of a few neighbouring cells of a Voronoi diagram."""

import numpy as np
from scipy.spatial import Voronoi
from shapely.geometry import Polygon

_DISORDER = 0.35
"""How far the middles of the cells may be off a regular grid, in its spacings."""
_SHORT = 0.4
"""Edges shorter than this many spacings become a corner."""


def winding_polygon(rng, spacing, length):
    """Corners of a simple polygon, counter-clockwise, shape (n, 2).

    Args:
        rng: numpy.random.Generator.
        spacing: of the cells, m; about how far parts of the outline keep away from each other.
        length: the outline grows until it is about as long as this, m.
    """
    cells = _cells(rng, spacing, int(np.ceil(np.sqrt(length / spacing))) + 3)
    middle = np.mean([cell.centroid.coords[0] for cell in cells], axis=0)
    cells.sort(key=lambda cell: np.hypot(*(np.array(cell.centroid.coords[0]) - middle)))
    shape, left = cells[0], cells[1:]
    while shape.length < length:
        grown = _grow(rng, shape, left)
        if grown is None:
            break
        shape = grown
    return _without_short_edges(np.array(shape.exterior.coords)[:-1][::-1], _SHORT * spacing)


def _cells(rng, spacing, count):
    grid = np.stack(np.meshgrid(np.arange(count), np.arange(count)), axis=-1).reshape(-1, 2)
    diagram = Voronoi(spacing * (grid + rng.uniform(-_DISORDER, _DISORDER, grid.shape)))
    regions = [diagram.regions[i] for i in diagram.point_region]
    cells = [Polygon(diagram.vertices[r]) for r in regions if r and -1 not in r]
    # Those at the rim are long and thin.
    return [cell for cell in cells if cell.length < 6.0 * spacing]


def _grow(rng, shape, left):
    """Add a cell that touches the shape along one line, so that no hole arises; or None."""
    for i in rng.permutation(len(left)):
        shared = shape.intersection(left[i])
        if shared.length < 1e-6:
            continue
        union = shape.union(left[i])
        # Small contact makes winding roads instead of round ones.
        snaky = shared.length < 0.4 * left[i].length
        if snaky and union.geom_type == "Polygon" and not union.interiors and _is_one_line(shared):
            del left[i]
            return union
    return None


def _is_one_line(shared):
    parts = getattr(shared, "geoms", [shared])
    ends = [np.round(end, 6).tobytes() for part in parts for end in (part.coords[0], part.coords[-1])]
    return len(set(ends)) == len(parts) + 1


def _without_short_edges(points, least):
    while len(points) > 4:
        lengths = np.hypot(*(np.roll(points, -1, axis=0) - points).T)
        i = int(np.argmin(lengths))
        if lengths[i] >= least:
            break
        following = (i + 1) % len(points)
        points[i] = 0.5 * (points[i] + points[following])
        points = np.delete(points, following, axis=0)
    return points if Polygon(points).exterior.is_ccw else points[::-1]
