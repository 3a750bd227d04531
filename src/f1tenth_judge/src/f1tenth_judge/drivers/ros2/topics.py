"""The topics of a car as f1tenth_gym_ros names them."""

from typing import NamedTuple

from cyclonedds.qos import Qos

from f1tenth_judge.drivers.ros2.messages.basic import Clock
from f1tenth_judge.drivers.ros2.messages.driving import AckermannDriveStamped
from f1tenth_judge.drivers.ros2.messages.geometry import PoseWithCovarianceStamped, TFMessage, Twist
from f1tenth_judge.drivers.ros2.messages.navigation import OccupancyGrid, Odometry
from f1tenth_judge.drivers.ros2.messages.sensing import Imu, LaserScan
from f1tenth_judge.drivers.ros2.quality import LATCHED, OFFERED

SCAN, CLOCK, IMU, MAP = "/scan", "/clock", "/imu", "/map"
TF, TF_STATIC = "/tf", "/tf_static"
# The true pose in the map, as in f1tenth_gym_ros: of the planner's car, and of the other one.
ODOMETRY = ("/ego_racecar/odom", "/odom")
OPPONENT_ODOMETRY = ("/opp_racecar/odom", "/ego_racecar/opp_odom")
DRIVE, TWIST, INITIAL_POSE = "/drive", "/cmd_vel", "/initialpose"

MAP_FRAME = "map"
EGO, OPPONENT = "ego_racecar", "opp_racecar"  # in front of the frames of the two cars


class Offer(NamedTuple):
    """What is published on a topic."""

    kind: type
    qos: Qos = OFFERED


OFFERS = {
    SCAN: Offer(LaserScan),
    **dict.fromkeys(ODOMETRY, Offer(Odometry)),
    IMU: Offer(Imu),
    TF: Offer(TFMessage),
    TF_STATIC: Offer(TFMessage, LATCHED),
    CLOCK: Offer(Clock),
}
MAP_OFFERS = {MAP: Offer(OccupancyGrid, LATCHED)}
OPPONENT_OFFERS = dict.fromkeys(OPPONENT_ODOMETRY, Offer(Odometry))
COMMANDS = {DRIVE: AckermannDriveStamped, TWIST: Twist}
REQUESTS = {**COMMANDS, INITIAL_POSE: PoseWithCovarianceStamped}


def base_frame(car: str) -> str:
    """The frame of a car's base, between its rear wheels."""
    return f"{car}/base_link"


def laser_frame(car: str) -> str:
    """The frame of a car's lidar."""
    return f"{car}/laser"
