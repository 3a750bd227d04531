"""builtin_interfaces, std_msgs and rosgraph_msgs."""

from dataclasses import dataclass, field

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import int32, uint32

_NANOSECONDS = 10**9


@dataclass
class Time(IdlStruct, typename="builtin_interfaces.msg.dds_.Time_"):
    """Simulated time."""

    sec: int32 = 0
    nanosec: uint32 = 0

    @classmethod
    def of(cls, seconds: float) -> "Time":
        """The nearest nanosecond."""
        return cls(*divmod(round(seconds * _NANOSECONDS), _NANOSECONDS))

    def to_sec(self) -> float:
        """In s; called as in ROS 1, so that one function reads messages of both."""
        return self.sec + self.nanosec / _NANOSECONDS


@dataclass
class Duration(IdlStruct, typename="builtin_interfaces.msg.dds_.Duration_"):
    """Of simulated time."""

    sec: int32 = 0
    nanosec: uint32 = 0

    to_sec = Time.to_sec


@dataclass
class Header(IdlStruct, typename="std_msgs.msg.dds_.Header_"):
    """When, and in which frame."""

    stamp: Time = field(default_factory=Time)
    frame_id: str = ""


@dataclass
class Clock(IdlStruct, typename="rosgraph_msgs.msg.dds_.Clock_"):
    """What /clock tells."""

    clock: Time = field(default_factory=Time)
