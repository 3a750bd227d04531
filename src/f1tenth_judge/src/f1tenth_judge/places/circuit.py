"""What a circuit consists of: the schema of `circuits/NAME.yaml`."""

import enum
from dataclasses import dataclass
from typing import NamedTuple

from f1tenth_judge.yaml_files.schema import Problem, key

MIN_RADIUS = 1.2
"""Least radius of a bend of the centreline, m; the car's least turning radius is 0.74 m."""
MIN_WIDTH = 1.2
MAX_WIDTH = 2.5
"""Width of the road between the faces of its walls, m."""


class Point(NamedTuple):
    """A place in the map frame."""

    x: float  # m
    y: float  # m


class Pose(NamedTuple):
    """A pose in the map frame."""

    x: float  # m
    y: float  # m
    yaw: float  # rad


@dataclass(frozen=True)
class Corner:
    """A corner of the polygon that the centreline follows, rounded off with `radius`."""

    at: Point = key("Where the corner is.", unit="m")
    radius: float = key("Radius of the centreline.", unit="m", at_least=MIN_RADIUS)
    width: float = key(
        "Width of the road here; on straights it changes evenly from one corner to the next.",
        unit="m",
        at_least=MIN_WIDTH,
        at_most=MAX_WIDTH,
    )


class OpeningKind(enum.Enum):
    """What an opening is."""

    DOOR = "door"
    WINDOW = "window"


OPENING_HEIGHTS = {OpeningKind.DOOR: (0.0, 2.0), OpeningKind.WINDOW: (1.0, 2.2)}
"""Lower and upper edge of an opening above the ground, m."""


@dataclass(frozen=True)
class Opening:
    """A door or window."""

    kind: OpeningKind = key("What it is.")
    near: Point = key("It is in the straight wall nearest to this place.", unit="m")
    width: float = key("Width.", unit="m", above=0)


@dataclass(frozen=True)
class Room:
    """Further walls: a room behind a door."""

    points: tuple[Point, ...] = key("The polyline that the walls follow.", unit="m")
    material: str = key("Of the walls.", default="Gazebo/Grey")

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        if len(self.points) < 2:
            return "points", f"must be a list of at least 2, found a list of {len(self.points)}"
        return None


@dataclass(frozen=True)
class Prop:
    """A model that stands in the circuit."""

    model: str = key("Name of the model.")
    at: Pose = key("Where it stands, m and rad.")


@dataclass(frozen=True)
class Circuit:
    """A closed race track whose start line is at the origin, with the driving direction +x."""

    corners: tuple[Corner, ...] = key("The way around, in driving order.")
    left_material: str = key("Of the walls.", default="Gazebo/Grey")
    right_material: str = key("Of the walls.", default="Gazebo/Grey")
    openings: tuple[Opening, ...] = key("Doors and windows in the walls of the road.", default=())
    rooms: tuple[Room, ...] = key("Further walls.", default=())
    props: tuple[Prop, ...] = key("What stands in the circuit.", default=())
    name: str = ""  # that of its file

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        if len(self.corners) < 3:
            return "corners", f"must be a list of at least 3, found a list of {len(self.corners)}"
        first, last = self.corners[0].at, self.corners[-1].at
        if not (first.y == last.y == 0 and last.x < 0 < first.x):
            return "corners", (
                "must lead through the origin in direction +x from the last to the first, "
                f"found ({last.x:g}, {last.y:g}) to ({first.x:g}, {first.y:g})"
            )
        return None
