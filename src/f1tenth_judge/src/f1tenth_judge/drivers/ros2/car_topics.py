"""The topics of one car in its planner's domain: what it senses goes out, what it is told comes in."""

from collections.abc import Iterable
from typing import Optional

from f1tenth_judge.drivers.ros2 import sensed
from f1tenth_judge.drivers.ros2.cameras import Cameras
from f1tenth_judge.drivers.ros2.connection import Connection
from f1tenth_judge.drivers.ros2.messages.basic import Clock, Time
from f1tenth_judge.drivers.ros2.messages.geometry import TFMessage, Twist
from f1tenth_judge.drivers.ros2.topics import (
    CLOCK,
    COMMANDS,
    EGO,
    IMU,
    INITIAL_POSE,
    MAP,
    MAP_OFFERS,
    ODOMETRY,
    OFFERS,
    OPPONENT,
    OPPONENT_ODOMETRY,
    OPPONENT_OFFERS,
    REQUESTS,
    SCAN,
    TF,
    TF_STATIC,
)
from f1tenth_judge.places.map_file import Grid
from f1tenth_judge.run.stage import Command, DriveCommand, Stage, TwistCommand

_RIVALS = "not repeatable, as at {:.3f} s several processes command {} at once: the last one counts"


class CarTopics:
    """Publishes for a car, and for what its planner sees of the other one.

    What publishes tells whether it has sent something: nobody waits for what nobody hears.
    """

    def __init__(self, connection: Connection, stage: Stage, car: str, grid: Optional[Grid]):
        """Offer all topics; `grid` is the map, if the place has one."""
        self._connection = connection
        self._stage = stage
        self._car = car
        self._others = [name for name in stage.cars if name != car]
        self._held: list[tuple] = []  # of what scans are made
        self._has_rivals = False  # whether several processes of it have sent different commands at once
        self._initial_poses = 0  # that the planner has sent: they move no car
        offers = OFFERS | (MAP_OFFERS if grid else {}) | (OPPONENT_OFFERS if self._others else {})
        for topic, (kind, qos) in offers.items():
            connection.offer(topic, kind, qos)
        for topic, kind in REQUESTS.items():
            connection.request(topic, kind)
        self._cameras = Cameras(connection, stage, car)
        transforms = self._cameras.transforms()
        if lidar := stage.lidar(car):
            transforms.append(sensed.lidar_transform(lidar, EGO))
        connection.publish(TF_STATIC, TFMessage(transforms))
        if grid:
            connection.publish(MAP, sensed.map_message(grid))

    def publish_sensed(self) -> bool:
        """Publish what the last period has brought, but for the scan, which is held, and the time."""
        time, states = self._stage.time, self._stage.states
        sent = [self._publish(ODOMETRY, sensed.odometry_message, states[self._car], time, EGO)]
        transforms = [sensed.pose_transform(states[self._car], time, EGO)]
        for other in self._others[:1]:  # f1tenth_gym_ros knows two cars
            sent.append(
                self._publish(OPPONENT_ODOMETRY, sensed.odometry_message, states[other], time, OPPONENT)
            )
            transforms.append(sensed.pose_transform(states[other], time, OPPONENT))
        sent.append(self._publish((TF,), TFMessage, transforms))
        sent += [self._publish_imu(), self._cameras.publish()]
        if scan := self._stage.scan(self._car):
            self._held.append((*scan, time, EGO))
        return any(sent)

    def _publish_imu(self) -> bool:
        samples = self._stage.imu_samples(self._car) if self._connection.hearers(IMU) else ()
        for time, sample in samples:
            self._connection.publish(IMU, sensed.imu_message(sample, self._stage.gravity, time, EGO))
        return bool(samples)

    def publish_scans(self) -> bool:
        """Publish the scans that are held."""
        sent = [self._publish((SCAN,), sensed.scan_message, *scan) for scan in self._held]
        self._held.clear()
        return any(sent)

    def publish_clock(self, time: float) -> bool:
        """Tell the time (s)."""
        return self._publish((CLOCK,), Clock, Time.of(time))

    def is_scan_heard(self) -> bool:
        """Whether somebody has subscribed to scans."""
        return self._connection.hearers(SCAN) > 0

    def note(self) -> list[str]:
        """What does not fit, in words."""
        placed = ["/initialpose moves no car in a judged run"] if self._initial_poses else []
        return [*self._cameras.note(), *placed]

    def take_commands(self) -> list[Command]:
        """What the planner has sent since, in order."""
        self._initial_poses += len(self._connection.take(INITIAL_POSE))
        taken = [(each, topic) for topic in COMMANDS for each in self._connection.take(topic)]
        taken.sort(key=lambda each: each[0].sample_info.source_timestamp)
        commands = [_command(message) for message, _ in taken]
        if not self._has_rivals and len(set(commands)) > 1:
            self._has_rivals = len({self._connection.process_of(*each) for each in taken}) > 1
            if self._has_rivals:
                self._stage.chances.append(_RIVALS.format(self._stage.time, self._car))
        return commands

    def _publish(self, topics: Iterable[str], make, *arguments) -> bool:
        """Publish a message on the topics that somebody hears."""
        heard = [topic for topic in topics if self._connection.hearers(topic)]
        if heard:
            message = make(*arguments)
            for topic in heard:
                self._connection.publish(topic, message)
        return bool(heard)


def _command(message) -> Command:
    if isinstance(message, Twist):
        return TwistCommand(message.linear.x, message.angular.z, message.linear.y)
    return DriveCommand(message.drive.speed, message.drive.steering_angle)
