"""What a car has sensed, as messages. Poses are those of base_footprint, exact, in the map."""

import f1tenth_sim2d
from f1tenth_judge.drivers.ros2.messages.basic import Header, Time
from f1tenth_judge.drivers.ros2.messages.geometry import (
    Pose,
    PoseWithCovariance,
    Quaternion,
    Transform,
    TransformStamped,
    Twist,
    TwistWithCovariance,
    Vector3,
)
from f1tenth_judge.drivers.ros2.messages.navigation import MapMetaData, OccupancyGrid, Odometry
from f1tenth_judge.drivers.ros2.messages.sensing import Imu, LaserScan
from f1tenth_judge.drivers.ros2.topics import MAP_FRAME, base_frame, laser_frame
from f1tenth_judge.places.map_file import Grid


def scan_message(lidar: f1tenth_sim2d.Lidar, ranges, time: float, car: str) -> LaserScan:
    """A scan at a time (s): `ranges` is an array in m, +inf where nothing was hit."""
    return LaserScan(
        Header(Time.of(time), laser_frame(car)),
        angle_min=lidar.angle_min,
        angle_max=lidar.angle_max,
        angle_increment=(lidar.angle_max - lidar.angle_min) / (lidar.beam_count - 1),
        scan_time=1.0 / lidar.rate_hz,
        range_min=lidar.range_min,
        range_max=lidar.range_max,
        ranges=ranges.tolist(),
    )


def odometry_message(state: f1tenth_sim2d.CarState, time: float, car: str) -> Odometry:
    """Pose and velocity of a car at a time (s)."""
    velocity = Twist(Vector3(state.v_x, state.v_y), Vector3(z=state.yaw_rate))
    return Odometry(
        Header(Time.of(time), MAP_FRAME),
        base_frame(car),
        PoseWithCovariance(Pose.planar(state.x, state.y, state.yaw)),
        TwistWithCovariance(velocity),
    )


def imu_message(sample: f1tenth_sim2d.CarState, gravity: float, time: float, car: str) -> Imu:
    """What an IMU along the axes of a car's base tells at a time (s); `gravity` in m/s^2."""
    return Imu(
        Header(Time.of(time), base_frame(car)),
        orientation=Quaternion.of_yaw(sample.yaw),
        angular_velocity=Vector3(z=sample.yaw_rate),
        linear_acceleration=Vector3(sample.a_x, sample.a_y, gravity),
    )


def pose_transform(state: f1tenth_sim2d.CarState, time: float, car: str) -> TransformStamped:
    """Where a car is in the map at a time (s)."""
    transform = Transform(Vector3(state.x, state.y), Quaternion.of_yaw(state.yaw))
    return TransformStamped(Header(Time.of(time), MAP_FRAME), base_frame(car), transform)


def lidar_transform(lidar: f1tenth_sim2d.Lidar, car: str) -> TransformStamped:
    """Where a car's lidar is, for /tf_static."""
    x, y, z, yaw = lidar.pose
    transform = Transform(Vector3(x, y, z), Quaternion.of_yaw(yaw))
    return TransformStamped(Header(frame_id=base_frame(car)), laser_frame(car), transform)


def map_message(grid: Grid) -> OccupancyGrid:
    """A map as map_server publishes it."""
    height, width = grid.cells.shape
    about = MapMetaData(Time(), grid.resolution, width, height, Pose.planar(grid.x, grid.y, 0.0))
    return OccupancyGrid(Header(frame_id=MAP_FRAME), about, grid.cells.ravel().tolist())
