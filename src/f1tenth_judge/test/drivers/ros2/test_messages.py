"""Messages on the wire, compared with the definitions that PyPI's rosbags brings."""

import dataclasses
import re

import numpy as np
import pytest
from cyclonedds.idl import IdlStruct
from f1tenth_judge.drivers.ros2.messages import basic, driving, geometry, navigation, sensing
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

KINDS = [
    kind
    for module in (basic, geometry, sensing, navigation, driving)
    for kind in vars(module).values()
    if isinstance(kind, type) and issubclass(kind, IdlStruct) and kind.__module__ == module.__name__
]
ACKERMANN = "ackermann_msgs/msg/AckermannDrive"
# The definitions of ackermann_msgs, which rosbags does not bring.
NUMBERS = ("steering_angle", "steering_angle_velocity", "speed", "acceleration", "jerk")
DRIVE = "\n".join(f"float32 {name}" for name in NUMBERS)
STAMPED = "std_msgs/Header header\nAckermannDrive drive"


def store_of(release):
    store = get_typestore(release)
    store.register(
        {**get_types_from_msg(DRIVE, ACKERMANN), **get_types_from_msg(STAMPED, ACKERMANN + "Stamped")}
    )
    return store


STORES = [store_of(Stores.ROS2_HUMBLE), store_of(Stores.ROS2_JAZZY)]


def name_in_ros(kind):
    return kind.__idl_typename__.replace(".dds_", "").removesuffix("_").replace(".", "/")


def filled(kind, random):
    """An instance with other values than the defaults in each field."""
    return kind(
        **{field.name: value_of(getattr(kind(), field.name), random) for field in dataclasses.fields(kind)}
    )


def value_of(default, random):
    if dataclasses.is_dataclass(default):
        return filled(type(default), random)
    if isinstance(default, list):
        return [float(each) for each in random.integers(0, 99, len(default) or 3)]
    return {str: "robot1/läser", int: 7, float: 0.375, bool: True, bytes: b"\x01\x02\xff"}[type(default)]


def in_store(store, value):
    """The same in the classes of rosbags."""
    if isinstance(value, list):
        return [in_store(store, each) for each in value]
    if not dataclasses.is_dataclass(value):
        return value
    kind = store.types[name_in_ros(type(value))]
    names = [field.name for field in dataclasses.fields(value)]
    types = {field.name: str(field.type) for field in dataclasses.fields(kind)}
    return kind(**{name: as_type(types[name], in_store(store, getattr(value, name))) for name in names})


def as_type(kind, value):
    """A list as the array that rosbags wants, if it wants one."""
    found = re.search(r"dtype\[np\.(\w+)\]", kind)
    return np.array([*value], dtype=found[1]) if found else value


@pytest.mark.parametrize("store", STORES, ids=["humble", "jazzy"])
@pytest.mark.parametrize("kind", KINDS, ids=name_in_ros)
def test_bytes_are_those_of_ros(kind, store):
    message = filled(kind, np.random.default_rng(1))
    if kind is geometry.TFMessage:
        message.transforms = [filled(geometry.TransformStamped, np.random.default_rng(n)) for n in range(2)]
    if kind is navigation.OccupancyGrid:
        message.data = [int(each) for each in message.data]
    expected = store.serialize_cdr(in_store(store, message), name_in_ros(kind))
    assert message.serialize(use_version_2=False) == bytes(expected)
