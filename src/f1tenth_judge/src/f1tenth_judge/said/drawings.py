"""What planners draw for rviz: markers, paths and poses of ROS 1 and 2, flat, as the replay draws them."""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Optional

from f1tenth_judge.record.replay import Drawing, Planar, Point
from f1tenth_judge.said.plane import placed, planar, point

# Where a frame is in the map at a stamp (s); nothing if nobody has said.
Frames = Callable[[str, float], Optional[Planar]]

_POINTS, _POSES, _MARKERS = 100, 50, 200  # of a line, a PoseArray, a topic, at most
_ARROW = 0.25  # m, of a pose
_HEAD = 0.3  # of an arrow's length
_ALL, _ADD, _DELETE = 3, 0, 2  # actions of a marker


class Board:
    """What a topic shows: markers stay until they are replaced, deleted or too old."""

    def __init__(self, kind: str, frames: Frames):
        """`kind` is one of KINDS."""
        self._frames = frames
        self._take = KINDS[kind]
        self._markers: dict[tuple[str, int], tuple[float, Drawing]] = {}  # until when (s)
        self._drawn: Sequence[Drawing] = ()

    def take(self, message, now: float) -> None:
        """Show a message, heard at `now` (s)."""
        self._take(self, message, now)

    def shown(self, now: float) -> list[Drawing]:
        """What is to be seen now (s)."""
        self._markers = {key: each for key, each in self._markers.items() if each[0] > now}
        drawn = [*self._drawn, *(drawing for _, drawing in self._markers.values())]
        return [each for each in drawn if each.lines or each.dots or each.texts][:_MARKERS]

    def _take_path(self, path, now: float) -> None:
        points = [point(each.pose.position) for each in _thinned(path.poses, _POINTS)]
        self._draw(path.header, now, Drawing(lines=[points]))

    def _take_poses(self, poses, now: float) -> None:
        arrows = [_arrow(planar(each), _ARROW) for each in _thinned(poses.poses, _POSES)]
        self._draw(poses.header, now, Drawing(lines=arrows))

    def _draw(self, header, now: float, drawing: Drawing) -> None:
        frame = self._frame(header, now)
        self._drawn = [] if frame is None else [_placed(frame, drawing)]

    def _frame(self, header, now: float) -> Optional[Planar]:
        """Where the frame of a message was; without a stamp it is meant to be now."""
        return self._frames(header.frame_id.lstrip("/"), header.stamp.to_sec() or now)

    def _take_array(self, array, now: float) -> None:
        for marker in array.markers:
            self._take_marker(marker, now)

    def _take_marker(self, marker, now: float) -> None:
        key = (marker.ns, marker.id)
        self._markers.pop(key, None)
        if marker.action == _ALL:
            self._markers.clear()
        if marker.action != _ADD:
            return
        frame = self._frame(marker.header, now)
        drawing = _drawing_of(marker)
        if frame is not None and drawing:
            life = marker.lifetime.to_sec()
            self._markers[key] = (now + life if life > 0 else math.inf, _placed(frame, drawing))


KINDS: dict[str, Callable[[Board, Any, float], None]] = {
    "visualization_msgs/Marker": Board._take_marker,
    "visualization_msgs/MarkerArray": Board._take_array,
    "nav_msgs/Path": Board._take_path,
    "geometry_msgs/PoseArray": Board._take_poses,
}


def _drawing_of(marker) -> Optional[Drawing]:
    """A marker in its own frame; nothing if it cannot be seen."""
    colour = next((each for each in (marker.color, *marker.colors[:1]) if each.a > 0), None)
    parts = _PARTS[marker.type](marker) if 0 <= marker.type < len(_PARTS) else {}
    if colour is None or not parts:
        return None
    return _placed(planar(marker.pose), Drawing(colour=_hex(colour), **parts))


def _hex(colour) -> str:
    parts = (min(max(each, 0.0), 1.0) if each == each else 0.0 for each in (colour.r, colour.g, colour.b))
    return "#" + "".join(f"{round(255 * each):02x}" for each in parts)


def _of_arrow(marker) -> dict[str, Any]:
    if len(marker.points) < 2:
        return {"lines": [_arrow((0.0, 0.0, 0.0), marker.scale.x)]}
    (x, y), (to_x, to_y) = map(point, marker.points[:2])
    return {"lines": [_arrow((x, y, math.atan2(to_y - y, to_x - x)), math.hypot(to_x - x, to_y - y))]}


def _of_cube(marker) -> dict[str, Any]:
    x, y = marker.scale.x / 2, marker.scale.y / 2
    return {"lines": [[(-x, -y), (x, -y), (x, y), (-x, y), (-x, -y)]]}


def _of_dot(marker) -> dict[str, Any]:
    return {"dots": [(0.0, 0.0, round(marker.scale.x / 2, 3))]}


def _of_strip(marker) -> dict[str, Any]:
    return {"lines": [_thinned(_points(marker), _POINTS)]}


def _of_pairs(marker) -> dict[str, Any]:
    points = _points(marker)
    return {"lines": _thinned([points[index : index + 2] for index in range(0, len(points) - 1, 2)], _POINTS)}


def _of_list(marker) -> dict[str, Any]:
    return {"dots": [(*each, round(marker.scale.x / 2, 3)) for each in _thinned(_points(marker), _POINTS)]}


def _of_text(marker) -> dict[str, Any]:
    return {"texts": [(0.0, 0.0, marker.text)]} if marker.text else {}


def _of_triangles(marker) -> dict[str, Any]:
    points = _points(marker)
    corners = [points[index : index + 3] for index in range(0, len(points) - 2, 3)]
    return {"lines": _thinned([[*each, each[0]] for each in corners], _POINTS)}


# By the number of the type: arrow, cube, sphere, cylinder, line strip, line list, cubes, spheres, points,
# text, mesh, triangles.
_PARTS = (
    _of_arrow,
    _of_cube,
    _of_dot,
    _of_dot,
    _of_strip,
    _of_pairs,
    _of_list,
    _of_list,
    _of_list,
    _of_text,
    _of_dot,
    _of_triangles,
)


def _points(marker) -> list[Point]:
    return [point(each) for each in marker.points]


def _arrow(pose: Planar, length: float) -> list[Point]:
    tip, back, side = length, (1 - _HEAD) * length, _HEAD / 2 * length
    return [placed(pose, each) for each in ((0, 0), (tip, 0), (back, side), (back, -side), (tip, 0))]


def _placed(frame: Planar, drawing: Drawing) -> Drawing:
    """The same, seen from where the frame is; without what a planner has not computed."""
    lines = [_finite(placed(frame, each) for each in line) for line in drawing.lines]
    return Drawing(
        drawing.colour,
        [line for line in lines if line],
        _finite((*placed(frame, (x, y)), radius) for x, y, radius in drawing.dots),
        [(*place, text) for x, y, text in drawing.texts for place in _finite([placed(frame, (x, y))])],
    )


def _finite(places: Iterable) -> list:
    return [each for each in places if all(map(math.isfinite, each))]


def _thinned(values: Sequence, most: int) -> list:
    return list(values[:: -(-len(values) // most) or 1])
