"""ackermann_msgs."""

from dataclasses import dataclass, field

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import float32

from f1tenth_judge.drivers.ros2.messages.basic import Header


@dataclass
class AckermannDrive(IdlStruct, typename="ackermann_msgs.msg.dds_.AckermannDrive_"):
    """rad, rad/s, m/s, m/s^2, m/s^3; angle and speed are obeyed, limits are the car's own."""

    steering_angle: float32 = 0.0
    steering_angle_velocity: float32 = 0.0
    speed: float32 = 0.0
    acceleration: float32 = 0.0
    jerk: float32 = 0.0


@dataclass
class AckermannDriveStamped(IdlStruct, typename="ackermann_msgs.msg.dds_.AckermannDriveStamped_"):
    """What planners send on /drive."""

    header: Header = field(default_factory=Header)
    drive: AckermannDrive = field(default_factory=AckermannDrive)
