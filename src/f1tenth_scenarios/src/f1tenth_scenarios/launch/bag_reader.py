"""What the replay shows of a bag: plans, models, and what planners draw and publish as numbers."""

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.record import STAMP_EPSILON
from f1tenth_judge.record.replay import Drawing, Numbers, Planar, Point, Poses, Replay, Timed

from f1tenth_scenarios.launch.drawings import KINDS, Board
from f1tenth_scenarios.launch.plane import planar, point
from f1tenth_scenarios.launch.thumbnails import thumbnail

_PLAN_PERIOD, _MODEL_PERIOD, _NUMBER_PERIOD = 0.2, 0.1, 0.025  # s, between two messages that the replay shows
_BURST = 0.05  # s, in which single markers make one drawing
_PLAN_POINTS = 100  # of a plan, about
_MOST_POINTS = 100_000  # of what a topic draws
_MOST_TOPICS = 20  # that draw, and that have numbers
_PICTURE_PERIOD, _MOST_PICTURES, _MOST_CAMERAS = 0.5, 300, 4  # s; of a camera, 1.5 MB; of all cars
_CAMERAS = ("sensor_msgs/Image", "sensor_msgs/CompressedImage")
_NUMBERS = ("std_msgs/Float32", "std_msgs/Float64")
_LAG = 0.1  # s, by which the last transform may be older than a drawing


def read_bag(bag: Path, cars: Sequence[str]) -> tuple[Replay, list[str]]:
    """What the replay shows of a bag, and the topics that are too much for it, in words.

    Raises:
        ScenarioError: the bag is missing or broken.
    """
    # Imported late: what is imported with it takes longer than reading a bag.
    import rosbag

    try:
        with rosbag.Bag(str(bag)) as opened:
            # Asked once: it goes through the index of every message.
            kinds = {name: each.msg_type for name, each in opened.get_type_and_topic_info().topics.items()}
            drawn, too_much = _drawings(opened, cars, kinds)
            numbers, more = _channels(opened, cars, kinds)
            seen, even_more = _pictures(opened, cars, kinds)
            replay = Replay(
                global_plans=_plans(opened, cars, "global_plan"),
                local_plans=_plans(opened, cars, "local_plan"),
                models=_models(opened, cars),
                drawings=drawn,
                channels=numbers,
                pictures=seen,
            )
            return replay, [*too_much, *more, *even_more]
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


def _drawings(bag, cars: Sequence[str], kinds: Mapping[str, str]) -> tuple[dict[str, Timed], list[str]]:
    frames = _Frames(bag)
    shown = [f"/{car}/move_base/{kind}" for car in cars for kind in ("global_plan", "local_plan")]
    topics = [topic for topic in _topics_of(bag, cars, kinds, KINDS) if topic not in shown]
    found, too_much = {}, []
    for topic in sorted(topics)[:_MOST_TOPICS]:
        drawn, until = _drawn(bag, topic, Board(kinds[topic], frames))
        if any(drawn.values):
            found[topic] = drawn
        if until is not None:
            too_much.append(
                f"{topic}: left out from {until:.3f} s on, as it has more than {_MOST_POINTS} points"
            )
    return found, [*too_much, *_crowded_out(topics)]


def _drawn(bag, topic: str, board: Board) -> tuple[Timed, Optional[float]]:
    """What a topic draws, and when (s) it was too much."""
    stamps: list[float] = []
    values: list[list[Drawing]] = []
    points = 0
    for now, message in _messages(bag, topic):
        board.take(message, now)
        if stamps and now < stamps[-1] + _BURST:
            values[-1] = board.shown(now)
        elif not stamps or now + STAMP_EPSILON >= stamps[-1] + _PLAN_PERIOD:
            points += _size(values[-1]) if values else 0
            if points > _MOST_POINTS:
                return Timed(stamps, values), now
            stamps.append(round(now, 9))
            values.append(board.shown(now))
    return Timed(stamps, values), None


def _messages(bag, topic: str) -> Iterator[tuple[float, Any]]:
    for _, message, heard in bag.read_messages([topic]):
        yield heard.to_sec(), message


def _size(drawn: Sequence[Drawing]) -> int:
    return sum(sum(map(len, each.lines)) + len(each.dots) + len(each.texts) for each in drawn)


def _channels(bag, cars: Sequence[str], kinds: Mapping[str, str]) -> tuple[dict[str, Numbers], list[str]]:
    topics = _topics_of(bag, cars, kinds, _NUMBERS)
    found = {}
    for topic in sorted(topics)[:_MOST_TOPICS]:
        stamps, values = [], []
        for now, message in _messages(bag, topic):
            is_due = not stamps or now + STAMP_EPSILON >= stamps[-1] + _NUMBER_PERIOD
            if is_due and math.isfinite(message.data):
                stamps.append(round(now, 9))
                values.append(message.data)
        if stamps:
            found[topic] = Numbers(stamps, values, topics[topic])
    return found, _crowded_out(topics)


def _pictures(bag, cars: Sequence[str], kinds: Mapping[str, str]) -> tuple[dict[str, Timed], list[str]]:
    """What the cameras of cars have shown to somebody: nobody draws them for the bag alone."""
    owned = [topic for topic in kinds if topic.startswith(tuple(f"/{car}/" for car in cars))]
    topics = [topic for topic in owned if kinds[topic] in _CAMERAS]
    found, too_much = {}, []
    for topic in sorted(topics)[:_MOST_CAMERAS]:
        seen, until = _seen(bag, topic)
        if seen.values:
            found[topic] = seen
        if until is not None:
            too_much.append(
                f"{topic}: left out from {until:.3f} s on, as there are more than {_MOST_PICTURES} pictures"
            )
    left = sorted(topics)[_MOST_CAMERAS:]
    too_much += [f"{topic}: left out, as there are more than {_MOST_CAMERAS} cameras" for topic in left]
    return found, too_much


def _seen(bag, topic: str) -> tuple[Timed, Optional[float]]:
    """What a camera showed, and when (s) it was too much."""
    stamps: list[float] = []
    values: list[str] = []
    for now, message in _messages(bag, topic):
        is_due = not stamps or now + STAMP_EPSILON >= stamps[-1] + _PICTURE_PERIOD
        if is_due and (small := thumbnail(message)):
            if len(values) == _MOST_PICTURES:
                return Timed(stamps, values), now
            stamps.append(round(now, 9))
            values.append(small)
    return Timed(stamps, values), None


def _crowded_out(topics) -> list[str]:
    return [
        f"{topic}: left out, as there are more than {_MOST_TOPICS} of its kind"
        for topic in sorted(topics)[_MOST_TOPICS:]
    ]


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
