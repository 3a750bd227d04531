"""The bag of a run: what was published on its topics, written by rosbag during the run."""

import math
import shlex
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.record import STAMP_EPSILON
from f1tenth_judge.record.replay import Planar, Point, Poses, Replay, Timed

RECORDER = "scenario_recorder"  # the node that writes it

_SHARED_TOPICS = ("/clock", "/tf", "/tf_static", "/map", "/time_to_start", "/gazebo/model_states")
# Of a car; what rviz shows, and what its planner hears and publishes. Costmaps would be most of the bag.
_CAR_TOPICS = (
    "scan",
    "odom",
    "perfect_odom",
    "joint_states",
    "bumper_front",
    "bumper_rear",
    "bumper_left",
    "bumper_right",
    "collision",
    "collisions",
    "cmd_vel",
    "drive",
    "amcl_pose",
    "particlecloud",
    "race_status",
    "race_goals",
    "move_base/goal",
    "move_base/cancel",
    "move_base/status",
    "move_base/feedback",
    "move_base/result",
    "move_base/current_goal",
    "move_base/global_plan",
    "move_base/local_plan",
)
_PLAN_PERIOD, _MODEL_PERIOD = 0.2, 0.1  # s, between two messages that the replay shows
_PLAN_POINTS = 100  # of a plan, about


def recorder_arguments(bag: Path, cars: Sequence[str], more: Sequence[str] = ()) -> str:
    """The command line of rosbag's `record`, as a launch file has it; `more`: topics besides."""
    topics = [*_SHARED_TOPICS, *(f"/{car}/{topic}" for car in cars for topic in _CAR_TOPICS), *more]
    return shlex.join(["--quiet", "--lz4", "--buffsize=0", "-O", str(bag), *topics])


def read_bag(bag: Path, cars: Sequence[str]) -> Replay:
    """What the replay shows of a bag: plans, and where models were, without their shapes.

    Raises:
        ScenarioError: the bag is missing or broken.
    """
    # Imported late: what is imported with it takes longer than reading a bag.
    import rosbag

    try:
        with rosbag.Bag(str(bag)) as opened:
            return Replay(
                global_plans=_plans(opened, cars, "global_plan"),
                local_plans=_plans(opened, cars, "local_plan"),
                models=_models(opened, cars),
            )
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
    return [_point(each.pose.position) for each in path.poses[::stride]]


def _point(position) -> Point:
    return round(position.x, 3), round(position.y, 3)


def planar(pose) -> Planar:
    """A geometry_msgs/Pose in the plane, m and rad."""
    turn = pose.orientation
    yaw = math.atan2(2 * (turn.w * turn.z + turn.x * turn.y), 1 - 2 * (turn.y * turn.y + turn.z * turn.z))
    return (*_point(pose.position), round(yaw, 4))
