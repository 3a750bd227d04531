"""Where a run takes place: the world, its map, its road, and where a car starts."""

import dataclasses
import math
from pathlib import Path
from typing import Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.places.course import Course, read_course
from f1tenth_judge.scenario.car import Pose
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.scenario.scenario import StartLine

_MAP_ENDING, _CENTERLINE = "_map", "_centerline.csv"
_ORIGIN = Pose(0.0, 0.0, 0.0)
# Between the gates of a lap, m; beyond the edge of the road, as centrelines tell their widths roughly, m.
_GATE_DISTANCE, _GATE_MARGIN = 4.0, 0.5
_LEAST_GATES = 4
_DIGITS = 9


@dataclasses.dataclass(frozen=True)
class Place:
    """What belongs to a world. The road is that of a circuit, else X_centerline.csv beside X_map.yaml."""

    world: Path
    map: Optional[Path]  # YAML
    road: Optional[Path]
    raceline: Optional[Path]

    @property
    def is_circuit(self) -> bool:
        """Whether the road is that of a circuit: its start line is at the origin (docs/contracts.md)."""
        return self.road is not None and self.road.suffix == ".yaml"

    def road_for(self, driver: Driver) -> Optional[Path]:
        """The middle of the road as a driver reads it: others' drivers do not know circuits' YAML files."""
        return self.road if driver.is_ours else _beside(self.world, _CENTERLINE) or self.road

    def line_for(self, driver: Driver) -> Optional[Path]:
        """What is best driven along: the raceline, else the middle of the road."""
        return self.raceline or self.road_for(driver)

    def start(self) -> Pose:
        """Where a car starts: on a track at the first point of its centreline, headed for the second.

        Raises:
            ScenarioError: the centreline cannot be read.
        """
        if self.road is None or self.is_circuit:
            return _ORIGIN
        course = read_course(self.road)
        heading = math.atan2(course.y[1] - course.y[0], course.x[1] - course.x[0])
        return firm(float(course.x[0]), float(course.y[0]), heading)

    @property
    def no_road(self) -> str:
        """What is missing of a place without a road, and how it is made."""
        wanted = _path_beside(self.world, _CENTERLINE)
        stem = self.world.with_suffix("")
        makes_map = [] if self.map else [f"make_map {self.world} -o {stem}"]
        tools = [*makes_map, f"make_centerline {self.map or f'{stem}.yaml'} -o {wanted}"]
        remedy = " and ".join(f"`rosrun f1tenth_gazebo {tool}`" for tool in tools)
        return f"{self.world} is no circuit, and there is no {wanted.name} beside it; make it with {remedy}"

    def ahead_of_start(self, way: float) -> Pose:
        """A pose some distance (m) along the middle of the road from there.

        Raises:
            ScenarioError: the centreline cannot be read, or there is none.
        """
        if self.road is None:
            raise ScenarioError(f"'ahead' of a car needs a road: {self.no_road}")
        start = self.start()
        return firm(*read_course(self.road).ahead_of(start.x, start.y, start.yaw, way))


def firm(x: float, y: float, yaw: float) -> Pose:
    """A pose (m, rad) without its last bits, in which the C libraries of two processors differ."""
    return Pose(round(x, _DIGITS), round(y, _DIGITS), round(yaw, _DIGITS))


def find_place(world: Path) -> Place:
    """Look for all that belongs to a world."""
    map_file = lookup.map_file(world)
    return Place(world, map_file, _road(world), _beside(world, "_raceline.csv"))


def line_across(course: Course, start: Pose) -> StartLine:
    """The start line at a pose: from one edge of the road to the other, also in a corner."""
    yaw = course.direction(start.x, start.y, start.yaw)
    most = sum(course.widths(start.x, start.y))
    right, left = (course.reach(start.x, start.y, yaw + side * math.pi / 2, most) for side in (-1, 1))
    return _line(Pose(start.x, start.y, yaw), right, left)


def gates_after(course: Course, line: StartLine) -> tuple[StartLine, ...]:
    """Lines across the road, in the order in which a lap from the start line leads through them."""
    count = max(_LEAST_GATES, math.ceil(course.length / _GATE_DISTANCE))
    ways = (course.length * number / count for number in range(1, count))
    poses = (Pose(*course.ahead_of(line.x, line.y, line.yaw, way)) for way in ways)
    return tuple(
        _line(pose, *(width + _GATE_MARGIN for width in _widths(course, pose)))
        for pose in poses
        if _divides_road(course, pose)
    )


def _divides_road(course: Course, pose: Pose) -> bool:
    """Whether all who drive along the road cross the line at a pose.

    At a sharp corner the line's inner end is in the middle of the road that leads there.
    """
    right, left = _widths(course, pose)
    edges = (
        (pose.x - aside * math.sin(pose.yaw), pose.y + aside * math.cos(pose.yaw)) for aside in (-right, left)
    )
    return all(math.dist(course.nearest(*edge), (pose.x, pose.y)) < _GATE_MARGIN for edge in edges)


def _widths(course: Course, pose: Pose) -> tuple[float, float]:
    """To the right and to the left of a pose on the centreline, m."""
    right, left = course.widths(pose.x, pose.y)
    return (right, left) if course.runs_along(pose.x, pose.y, pose.yaw) else (left, right)


def _line(pose: Pose, right: float, left: float) -> StartLine:
    shift = (left - right) / 2
    x, y = pose.x - shift * math.sin(pose.yaw), pose.y + shift * math.cos(pose.yaw)
    return StartLine(x, y, pose.yaw, right + left)


def _road(world: Path) -> Optional[Path]:
    # A circuit says more than the centreline that is written beside its world.
    return _circuit(world) or _beside(world, _CENTERLINE)


def _circuit(world: Path) -> Optional[Path]:
    try:
        circuit = lookup.course_file(world.stem, world.parent)
    except ScenarioError:
        return None
    # Somebody else's world may have the name of a circuit.
    return circuit if circuit.parent.parent == world.parent.parent else None


def _beside(world: Path, ending: str) -> Optional[Path]:
    path = _path_beside(world, ending)
    return path if path.is_file() else None


def _path_beside(world: Path, ending: str) -> Path:
    return world.with_name(world.stem.removesuffix(_MAP_ENDING) + ending)
