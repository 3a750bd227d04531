"""What the replay shows of a bag: plans, models, and what planners draw and publish as numbers."""

import dataclasses
import functools
import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.files import reading
from f1tenth_judge.record.record import STAMP_EPSILON
from f1tenth_judge.record.replay import Planar, Point, Poses, Replay, Timed
from f1tenth_judge.said.drawings import KINDS, Board
from f1tenth_judge.said.plane import planar, point
from f1tenth_judge.said.said import Said
from f1tenth_judge.said.thumbnails import thumbnail

_PLAN_PERIOD, _MODEL_PERIOD = 0.2, 0.1  # s, between two messages that the replay shows
_PLAN_POINTS = 100  # of a plan, about
_CAMERAS = ("sensor_msgs/Image", "sensor_msgs/CompressedImage")
_NUMBERS = ("std_msgs/Float32", "std_msgs/Float64")
# Of a car, what the replay shows otherwise: plans and goals.
_SHOWN = ("move_base/global_plan", "move_base/local_plan", "move_base/goals_ahead", "race_goals")
_LAG = 0.1  # s, by which the last transform may be older than a drawing


def read_bag(bag: Path, cars: Sequence[str]) -> tuple[Replay, list[str]]:
    """What the replay shows of a bag, and the topics that are too much for it, in words.

    Raises:
        ScenarioError: the bag is missing or broken.
    """
    # Imported late: what is imported with it takes longer than reading a bag.
    import rosbag

    try:
        with reading(bag) as stream, rosbag.Bag(stream) as opened:
            # Asked once: it goes through the index of every message.
            kinds = {name: each.msg_type for name, each in opened.get_type_and_topic_info().topics.items()}
            said = Said()
            for read in (_drawings, _channels, _pictures):
                read(opened, cars, kinds, said)
            replay = dataclasses.replace(
                said.replay(),
                global_plans=_plans(opened, cars, "global_plan"),
                local_plans=_plans(opened, cars, "local_plan"),
                models=_models(opened, cars),
            )
            return replay, said.left_out
    except (OSError, rosbag.ROSBagException) as error:
        raise ScenarioError(f"{bag}: cannot be read: {error}") from error


def _plans(bag, cars: Sequence[str], kind: str) -> dict[str, Timed]:
    from nav_msgs.msg import Path as PathMessage

    plans = {}
    for car in cars:
        messages = [each for _, each in _due(bag, f"/{car}/move_base/{kind}", PathMessage, _PLAN_PERIOD)]
        if messages:
            stamps = [round(each.header.stamp.to_sec(), 9) for each in messages]
            plans[car] = Timed(stamps, [_points(each) for each in messages])
    return plans


def _models(bag, cars: Sequence[str]) -> dict[str, Poses]:
    from gazebo_msgs.msg import ModelStates

    found: dict[str, tuple[list, list]] = {}
    for stamp, states in _due(bag, "/gazebo/model_states", ModelStates, _MODEL_PERIOD):
        for name, pose in zip(states.name, states.pose):
            stamps, values = found.setdefault(name, ([], []))
            place = planar(pose)
            if name not in cars and values[-1:] != [place]:
                stamps.append(round(stamp, 9))
                values.append(place)
    return {name: Poses(*kept) for name, kept in found.items() if kept[0]}


def _drawings(bag, cars: Sequence[str], kinds: Mapping[str, str], said: Said) -> None:
    frames = _Frames(bag)
    shown = {f"/{car}/{topic}" for car in cars for topic in _SHOWN}
    for topic in sorted(_topics_of(bag, cars, kinds, KINDS).keys() - shown):
        board = Board(kinds[topic], frames)
        for now, message in _messages(bag, topic):
            board.take(message, now)
            if not said.draw(topic, now, board.shown):
                break


def _messages(bag, topic: str) -> Iterator[tuple[float, Any]]:
    for _, message, heard in bag.read_messages([topic]):
        yield heard.to_sec(), message


def _channels(bag, cars: Sequence[str], kinds: Mapping[str, str], said: Said) -> None:
    for topic, car in sorted(_topics_of(bag, cars, kinds, _NUMBERS).items()):
        for now, message in _messages(bag, topic):
            if not said.number(topic, now, message.data, car):
                break


def _pictures(bag, cars: Sequence[str], kinds: Mapping[str, str], said: Said) -> None:
    """What the cameras of cars have shown to somebody: nobody draws them for the bag alone."""
    owned = [topic for topic in kinds if topic.startswith(tuple(f"/{car}/" for car in cars))]
    for topic in sorted(topic for topic in owned if kinds[topic] in _CAMERAS):
        for now, message in _messages(bag, topic):
            if not said.picture(topic, now, functools.partial(thumbnail, message)):
                break


def _topics_of(bag, cars: Sequence[str], kinds: Mapping[str, str], wanted: Collection[str]) -> dict[str, str]:
    """The topics of the wanted kinds that nodes of cars publish, and of which car."""
    found = {}
    for topic, kind in kinds.items():
        if kind in wanted:
            first = next(bag.read_messages([topic], raw=True, return_connection_header=True))
            car = first.connection_header["callerid"].decode().strip("/").partition("/")[0]
            if car in cars:
                found[topic] = car
    return found


class _Frames:
    """Where frames were, by the transforms in a bag."""

    def __init__(self, bag):
        self._bag = bag
        self._buffer = None

    def __call__(self, frame: str, stamp: float) -> Optional[Planar]:
        import genpy
        import tf2_py

        if frame in ("", "map"):
            return 0.0, 0.0, 0.0
        for at in (stamp, stamp - _LAG):
            try:
                found = self._filled().lookup_transform_core("map", frame, genpy.Time.from_sec(max(at, 0.0)))
            except tf2_py.TransformException:
                continue
            return _planar_transform(found.transform)
        return None

    def _filled(self):
        """All transforms: they are read when the first is asked for, as most planners draw in the map."""
        import genpy
        import tf2_py
        from tf2_msgs.msg import TFMessage

        if self._buffer is None:
            self._buffer = tf2_py.BufferCore(genpy.Duration(10**6))
            known = set()  # several nodes may publish the same, of which the buffer would complain
            for topic, raw, _ in self._bag.read_messages(["/tf", "/tf_static"], raw=True):
                set_one = (
                    self._buffer.set_transform_static if topic == "/tf_static" else self._buffer.set_transform
                )
                for each in TFMessage().deserialize(raw[1]).transforms:
                    key = (each.child_frame_id, each.header.stamp)
                    if key not in known:
                        known.add(key)
                        set_one(each, "bag")
        return self._buffer


def _planar_transform(transform) -> Planar:
    from geometry_msgs.msg import Pose

    return planar(Pose(transform.translation, transform.rotation))


def _due(bag, topic: str, kind: type, period: float) -> Iterator[tuple[float, Any]]:
    """At most one message per period (s of simulated time), and when it was heard (s)."""
    following = -math.inf
    for _, raw, heard in bag.read_messages([topic], raw=True):
        stamp = heard.to_sec()
        if stamp + STAMP_EPSILON >= following:
            following = stamp + period
            yield stamp, kind().deserialize(raw[1])


def _points(path) -> list[Point]:
    stride = max(1, len(path.poses) // _PLAN_POINTS)
    return [point(each.pose.position) for each in path.poses[::stride]]
