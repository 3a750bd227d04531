"""A random road, and the proof that it can be driven."""

from dataclasses import dataclass, field, replace

import numpy as np
from shapely.geometry import Polygon

from f1tenth_gazebo.roads.clearance import clearance
from f1tenth_gazebo.roads.islands import around, place_islands
from f1tenth_gazebo.roads.layout import draw_centreline, draw_widths
from f1tenth_gazebo.roads.outline import Line
from f1tenth_gazebo.roads.road_options import MIN_WIDTH, RoadError, RoadOptions, describe, drawn_options
from f1tenth_gazebo.roads.road_walls import corners_of, road_ground, road_walls, with_gaps

_ATTEMPTS = 200
_EASING = 40
"""Attempts after which nothing is left of the features that a seed has drawn."""
TOLERANCE = 0.03
"""Tolerance of radii and widths, m: the line is a polygon, and walls are straight pieces."""


@dataclass(frozen=True)
class Road:
    """A closed road whose start is the origin, with the driving direction +x there. Lengths in m."""

    seed: int
    options: RoadOptions
    line: Line
    """The way that can be driven: the centreline, or beside an island the middle of the passage."""
    to_right: np.ndarray
    """From each sample of the line to the nearest thing solid on its right."""
    to_left: np.ndarray
    walls: list
    """f1tenth_gazebo.worlds.walls.Wall"""
    islands: list
    """(x, y, radius)"""
    inside: Polygon = field(repr=False)
    """The ground between the middles of the walls."""

    def outlines(self):
        """Of the walls' boxes, arrays of shape (4, 2)."""
        return [corners_of(wall) for wall in self.walls]

    def least_radius(self):
        """Of the line."""
        return float(1.0 / np.max(np.abs(self.line.curvatures)))

    def least_width(self):
        """Of the road or of a passage beside an island."""
        return float(2.0 * np.min([self.to_right, self.to_left]))


def make_road(seed, **given):
    """Make the road that belongs to a seed; the same one every time.

    A seed that draws more hairpins, chicanes or islands than there is room for gets fewer of them, or a
    longer straight; what is given is never changed.

    Args:
        seed: 0 or above.
        given: values for fields of RoadOptions; the seed draws the others. `width` may be one number.

    Raises:
        RoadError: for options that are not allowed, or that no road was found for.
    """
    if seed < 0:
        raise RoadError(f"seed: found {seed}, allowed: 0 and above")
    rng = np.random.default_rng(seed)
    options = drawn_options(rng, **given)
    for attempt in range(_ATTEMPTS):
        road = _attempt(rng, seed, _eased(options, given, attempt))
        if road is not None and can_be_driven(road):
            return road
    raise RoadError(f"seed {seed}: found no road with {describe(options)}; allowed: fewer or milder features")


def can_be_driven(road):
    """Whether the line keeps to the least radius and to the least width, with a tolerance of TOLERANCE."""
    least = MIN_WIDTH if road.islands else road.options.width[0]
    return road.least_radius() >= road.options.radius - TOLERANCE and road.least_width() >= least - TOLERANCE


def _eased(options, given, attempt):
    """With fewer features and a longer straight after each attempt, as far as they are not given."""
    share = max(0.0, 1.0 - attempt / _EASING)
    eased = {name: int(getattr(options, name) * share) for name in ("hairpins", "chicanes", "islands")}
    longest = min(80.0, options.length / 3.0)
    eased["straight"] = min(longest, options.straight * (1.0 + 6.0 * attempt / _EASING))
    return replace(options, **{name: value for name, value in eased.items() if name not in given})


def _attempt(rng, seed, options):
    centreline = draw_centreline(rng, options)
    if centreline is None:
        return None
    widths = draw_widths(rng, options, centreline)
    placed = place_islands(rng, centreline, widths, options)
    ground = road_ground(centreline, widths)
    built = ground and road_walls(rng, ground, options)
    if placed is None or built is None:
        return None
    islands, offsets = placed
    (outer, inner), inside = built
    line = around(centreline, offsets)
    left, right = (inner, outer) if Polygon(line.points).exterior.is_ccw else (outer, inner)
    right_side, left_side = [
        clearance(line.points, [corners_of(wall) for wall in walls], islands_there)
        for walls, islands_there in ((right, islands[0]), (left, islands[1]))
    ]
    walls = with_gaps(rng, [*outer, *inner], options.gaps)
    return Road(seed, options, line, right_side, left_side, walls, [*islands[0], *islands[1]], inside)
