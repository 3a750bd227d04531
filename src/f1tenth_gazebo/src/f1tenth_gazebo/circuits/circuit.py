"""What a circuit consists of."""

from dataclasses import dataclass, field

MIN_RADIUS = 1.2
"""Least radius of a bend of the centreline, m; the car's least turning radius is 0.74 m."""
MIN_WIDTH = 1.2
MAX_WIDTH = 2.5
"""Width of the road between the faces of its walls, m."""


@dataclass(frozen=True)
class Corner:
    """A corner of the polygon that the centreline follows, rounded off with `radius`."""

    x: float  # m
    y: float  # m
    width: float  # of the road here, m; on straights it changes evenly from one corner to the next
    radius: float  # of the centreline, m


@dataclass(frozen=True)
class Opening:
    """A door or window in the straight wall nearest to (x, y)."""

    kind: str  # a key of OPENING_HEIGHTS
    x: float  # m
    y: float  # m
    width: float  # m


@dataclass(frozen=True)
class Room:
    """Further walls, along a polyline of (x, y) in m: a room behind a door."""

    points: tuple
    material: str


@dataclass(frozen=True)
class Prop:
    """A model that stands in the circuit."""

    model: str
    x: float  # m
    y: float  # m
    yaw: float  # rad


@dataclass(frozen=True)
class Circuit:
    """A closed race track whose start line is at the origin, with the driving direction +x."""

    name: str
    corners: tuple
    left_material: str = "Gazebo/Grey"
    right_material: str = "Gazebo/Grey"
    openings: tuple = field(default=())
    rooms: tuple = field(default=())
    props: tuple = field(default=())


OPENING_HEIGHTS = {"door": (0.0, 2.0), "window": (1.0, 2.2)}
"""Lower and upper edge of an opening above the ground, m."""
