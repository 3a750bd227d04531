"""What a planner draws and publishes as numbers, on topics of its own: for the replay."""

import math
from typing import Optional

from f1tenth_judge.drivers.ros2.connection import Connection, type_in_ros
from f1tenth_judge.drivers.ros2.messages.drawing import Float32, Float64, Marker, MarkerArray, Path, PoseArray
from f1tenth_judge.drivers.ros2.topics import EGO, MAP_FRAME, OPPONENT, base_frame, laser_frame
from f1tenth_judge.record.replay import Planar
from f1tenth_judge.run.stage import Stage
from f1tenth_judge.said.drawings import KINDS, Board
from f1tenth_judge.said.plane import placed

_LOOK_INTERVAL = 1.0  # simulated s, between two looks for new topics
_TYPES = {type_in_ros(kind): kind for kind in (Float32, Float64, Marker, MarkerArray, Path, PoseArray)}


class OwnTopics:
    """Of the planner of one car."""

    def __init__(self, connection: Connection, stage: Stage, car: str):
        """Nothing was published yet."""
        self._connection, self._stage, self._car = connection, stage, car
        self._boards: dict[str, Optional[Board]] = {}  # by topic; none: its numbers
        self._looked = -math.inf
        self._unreadable: set[str] = set()

    def take(self) -> None:
        """Keep what has come since."""
        if self._stage.time - self._looked >= _LOOK_INTERVAL:
            self._looked = self._stage.time
            self._look_for_topics()
        for topic in self._boards.keys() - self._unreadable:
            try:
                self._take(topic)
            except Exception:  # another definition of the type, whose bytes may be anything
                self._unreadable.add(topic)

    def note(self) -> list[str]:
        """What could not be read, in words."""
        return [
            f"{topic} cannot be read: its type is not that of ROS 2 Humble"
            for topic in sorted(self._unreadable)
        ]

    def _look_for_topics(self) -> None:
        for end in self._connection.published():
            if end.type in _TYPES and end.topic not in self._boards:
                self._connection.listen(end, _TYPES[end.type])
                kind = end.type.replace("/msg/", "/")
                self._boards[end.topic] = Board(kind, self._place_of) if kind in KINDS else None

    def _take(self, topic: str) -> None:
        messages, board = self._connection.take(topic), self._boards[topic]
        said, now = self._stage.said, self._stage.time
        # Planners of several cars may use the same names, each in its domain.
        name = topic if len(self._stage.cars) == 1 else f"/{self._car}{topic}"
        for message in messages:
            if board is None:
                said.number(name, now, message.data, self._car)
            else:
                board.take(message, now)
        if board and messages:
            said.draw(name, now, board.shown)

    def _place_of(self, frame: str, _stamp: float) -> Optional[Planar]:
        """Where a frame is now: what is drawn in a period is of its scan."""
        if frame in ("", MAP_FRAME):
            return 0.0, 0.0, 0.0
        others = [name for name in self._stage.cars if name != self._car]
        for car, prefix in ((self._car, EGO), *((other, OPPONENT) for other in others)):
            state = self._stage.states[car]
            base = state.x, state.y, state.yaw
            if frame == base_frame(prefix):
                return base
            lidar = self._stage.lidar(car)
            if lidar and frame == laser_frame(prefix):
                x, y, _, yaw = lidar.pose
                return (*placed(base, (x, y)), state.yaw + yaw)
        return None
