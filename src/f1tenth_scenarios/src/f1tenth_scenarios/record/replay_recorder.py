"""Hears what a replay needs, at a low rate: scans, plans and movable models. Needs a running rospy node."""

import math
import struct
from collections.abc import Iterator, Sequence
from typing import Any, Callable

import rospy
from gazebo_msgs.msg import ModelStates
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav_msgs.msg import Path
from sensor_msgs.msg import LaserScan

from f1tenth_scenarios.record.recording import Rate, Recording
from f1tenth_scenarios.record.replay import Paths, Planar, Point, Poses, Scans

_PERIOD = 0.1  # s, simulated, between two messages that are kept
_BEAM_STRIDE = 10  # one of so many beams is kept
_PATH_POINTS = 100  # of a plan, about
_HEADER_START = struct.Struct("<III")  # seq, secs, nsecs
_BUFFER = 1 << 20  # bytes


class ReplayRecorder:
    """Keeps what is due and does not even decode the rest."""

    def __init__(self, cars: Sequence[str]):
        self._cars = tuple(cars)
        self._kept: dict[tuple[str, str], tuple[list, list]] = {}
        self._fans: dict[str, tuple[float, float]] = {}
        self.now = 0.0  # s, stamp of the last message
        self._subscribers = [each for car in cars for each in self._subscribe_car(car)]
        self._subscribers.append(self._subscribe_models())

    def close(self) -> None:
        """Stop listening."""
        for each in self._subscribers:
            each.unregister()

    def recording(self) -> Recording:
        """What was heard so far."""
        return Recording(
            scans={
                car: Scans(*kept, angle_min=self._fans[car][0], angle_max=self._fans[car][1])
                for car, kept in self._of_kind("scan")
            },
            global_plans={car: Paths(*kept) for car, kept in self._of_kind("global_plan")},
            local_plans={car: Paths(*kept) for car, kept in self._of_kind("local_plan")},
            estimates={car: Poses(*kept) for car, kept in self._of_kind("estimate")},
            models={name: Poses(*kept) for name, kept in self._of_kind("model")},
        )

    def _subscribe_car(self, car: str) -> Iterator[rospy.Subscriber]:
        yield self._subscribe(f"/{car}/scan", LaserScan, lambda scan: self._keep_scan(car, scan))
        for kind in ("global_plan", "local_plan"):
            topic = f"/{car}/move_base/{kind}"
            yield self._subscribe(topic, Path, lambda path, kind=kind: self._keep_path(kind, car, path))

        yield rospy.Subscriber(
            f"/{car}/amcl_pose",
            PoseWithCovarianceStamped,
            lambda estimate: self._keep_estimate(car, estimate),
        )

    def _subscribe(self, topic: str, kind: type, keep: Callable[[Any], None]) -> rospy.Subscriber:
        rate = Rate(_PERIOD)

        def receive(raw: rospy.AnyMsg) -> None:
            _, seconds, nanoseconds = _HEADER_START.unpack_from(raw._buff)
            self.now = seconds + nanoseconds * 1e-9
            if rate.is_due(self.now):
                keep(kind().deserialize(raw._buff))

        return rospy.Subscriber(topic, rospy.AnyMsg, receive, buff_size=_BUFFER)

    def _subscribe_models(self) -> rospy.Subscriber:
        rate = Rate(_PERIOD)

        def receive(raw: rospy.AnyMsg) -> None:
            # The message has no stamp; the cars' scans of the same period have.
            if rate.is_due(self.now):
                self._keep_models(ModelStates().deserialize(raw._buff))

        return rospy.Subscriber("/gazebo/model_states", rospy.AnyMsg, receive, buff_size=_BUFFER)

    def _keep_scan(self, car: str, scan: LaserScan) -> None:
        kept = scan.ranges[::_BEAM_STRIDE]
        self._fans[car] = (
            scan.angle_min,
            scan.angle_min + (len(kept) - 1) * _BEAM_STRIDE * scan.angle_increment,
        )
        self._keep("scan", car, scan.header.stamp.to_sec(), [_centimetres(each) for each in kept])

    def _keep_estimate(self, car: str, estimate: PoseWithCovarianceStamped) -> None:
        self._keep("estimate", car, estimate.header.stamp.to_sec(), _planar(estimate.pose.pose))

    def _keep_path(self, kind: str, car: str, path: Path) -> None:
        stride = max(1, len(path.poses) // _PATH_POINTS)
        points = [_point(each.pose.position) for each in path.poses[::stride]]
        self._keep(kind, car, path.header.stamp.to_sec(), points)

    def _keep_models(self, states: ModelStates) -> None:
        for name, pose in zip(states.name, states.pose):
            planar = _planar(pose)
            _, values = self._kept.get(("model", name), ([], []))
            if name not in self._cars and values[-1:] != [planar]:
                self._keep("model", name, self.now, planar)

    def _keep(self, kind: str, name: str, stamp: float, value: Any) -> None:
        stamps, values = self._kept.setdefault((kind, name), ([], []))
        stamps.append(round(stamp, 9))
        values.append(value)

    def _of_kind(self, wanted: str) -> list[tuple[str, tuple[list, list]]]:
        return [(name, kept) for (kind, name), kept in self._kept.items() if kind == wanted]


def _centimetres(distance: float) -> int:
    return round(distance * 100) if math.isfinite(distance) else 0


def _point(position) -> Point:
    return round(position.x, 3), round(position.y, 3)


def _planar(pose) -> Planar:
    turn = pose.orientation
    yaw = math.atan2(2 * (turn.w * turn.z + turn.x * turn.y), 1 - 2 * (turn.y * turn.y + turn.z * turn.z))
    return (*_point(pose.position), round(yaw, 4))
