"""A running simulation, watched in a browser: `live:=true` of the launch files."""

import math
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Callable, Optional

import rospy
from f1tenth_judge.places.goals import yaw_of
from f1tenth_judge.report.live.rows import Rows
from f1tenth_judge.report.live.watching import Serving
from gazebo_msgs.msg import ModelStates

_NAME = "simulation"


class Live:
    """Serves the cars among the models; those are the ones with a robot_description."""

    def __init__(self, folder: Path, parameter: Callable[[str], str]):
        """Begin to serve as soon as there is a car.

        Args:
            folder: for the record, of this object alone
            parameter: gives a parameter of ROS by its name, empty if there is none
        """
        self._file = folder / "record.csv"
        self._parameter = parameter
        self._rows = Rows(self._file)
        self._serving: Optional[Serving] = None
        self._models: set[str] = set()  # those that were asked for, cars or not
        self._cars: dict[str, str] = {}  # robot_description by name
        self._time = math.inf

    def close(self) -> None:
        """Stop serving."""
        self._rows.close()
        if self._serving:
            self._serving.close()

    def take(self, states, now: float) -> None:
        """Show gazebo_msgs/ModelStates at a time (s); one that goes back begins anew."""
        if not self._models.issuperset(states.name):
            self._look_for_cars(states.name)
        if now < self._time:
            self._rows.begin()
        self._time = now
        for name, pose, twist in zip(states.name, states.pose, states.twist):
            if name in self._cars:
                self._rows.write(now, name, **_columns(pose, twist))
        self._rows.flush()

    def _look_for_cars(self, models) -> None:
        new = {name: self._parameter(f"/{name}/robot_description") for name in {*models} - self._models}
        self._models.update(models)
        if cars := {name: text for name, text in new.items() if text}:
            self._cars.update(cars)
            task = task_of(self._cars, self._parameter("/sim2d/world"), self._file)
            if self._serving:
                self._serving.say(task)
            else:
                self._serving = Serving([task], _NAME, self._file.parent)


def task_of(descriptions: Mapping[str, str], world: str, record: Path) -> dict:
    """What the page needs to know; `descriptions`: robot_description by car."""
    return {
        "name": _NAME,
        "description": Path(world).stem,
        "cars": {},
        "descriptions": {name: (text, "robot_description") for name, text in descriptions.items()},
        "world": world,
        "goals": {},
        "road": [],
        "record": str(record),
        "interventions": str(record.with_name("none")),
    }


def _columns(pose, twist) -> dict[str, float]:
    """Columns of a record; Gazebo gives velocities in the frame of the world."""
    turn, velocity = pose.orientation, twist.linear
    yaw = yaw_of(turn.x, turn.y, turn.z, turn.w)
    along = math.cos(yaw) * velocity.x + math.sin(yaw) * velocity.y
    return {"x": pose.position.x, "y": pose.position.y, "yaw": yaw, "v_x": along}


def main() -> int:
    """Serve until the node is told to end."""
    rospy.init_node("live")
    with tempfile.TemporaryDirectory(prefix="f1tenth_live") as folder:
        live = Live(Path(folder), lambda name: rospy.get_param(name, ""))
        topic, now = "/gazebo/model_states", rospy.get_time
        rospy.Subscriber(topic, ModelStates, lambda states: live.take(states, now()), queue_size=1)
        rospy.spin()
        live.close()
    return 0
