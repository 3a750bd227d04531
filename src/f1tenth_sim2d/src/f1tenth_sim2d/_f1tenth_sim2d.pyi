"""Types of the module in C++; docstrings are in the module itself. What cannot be set is Final."""

from os import PathLike
from typing import Any, Final

from numpy import bool_, float32, float64, int8, uint8
from numpy.typing import NDArray

class Error(Exception): ...
class LoadError(Error): ...

class TireParameters:
    def __init__(self) -> None: ...
    p_cx1: float
    p_dx1: float
    p_ex1: float
    p_kx1: float
    p_hx1: float
    p_vx1: float
    r_bx1: float
    r_bx2: float
    r_cx1: float
    r_ex1: float
    r_hx1: float
    p_cy1: float
    p_dy1: float
    p_ey1: float
    p_ky1: float
    r_by1: float
    r_by2: float
    r_by3: float
    r_cy1: float
    r_ey1: float
    r_hy1: float
    r_vy1: float
    r_vy4: float
    r_vy5: float
    r_vy6: float

class VehicleParameters:
    model: str
    R_w: float
    I_y_w: float
    T_sb: float
    T_se: float
    tire: TireParameters
    @staticmethod
    def load(path: str | PathLike[str]) -> VehicleParameters: ...
    def __init__(self) -> None: ...
    def __copy__(self) -> VehicleParameters: ...
    C_Sf: float
    C_Sr: float
    I_z: float
    a_max: float
    actuation_latency: float
    command_timeout: float
    h: float
    l_f: float
    l_r: float
    m: float
    mu: float
    odometry_rate_hz: float
    odometry_speed_noise_stddev: float
    odometry_speed_scale: float
    odometry_steering_noise_stddev: float
    odometry_steering_offset: float
    speed_gain: float
    steering_max: float
    steering_rate_max: float
    v_max: float
    v_min: float
    v_switch: float
    wheelbase: Final[float]

class Model:
    def section(self, z: float) -> tuple: ...
    collisions: Final[list[str]]
    is_static: Final[bool]
    mass: Final[float]
    name: Final[str]
    pose: Final[tuple]

class World:
    def section(self, z: float) -> tuple: ...
    file: Final[str]
    gravity: Final[float]
    models: Final[list[Model]]
    name: Final[str]
    start: Final[tuple]
    warnings: Final[list[str]]

class Lidar:
    angle_max: Final[float]
    angle_min: Final[float]
    beam_count: Final[int]
    frame: Final[str]
    name: Final[str]
    noise_mean: Final[float]
    noise_stddev: Final[float]
    pose: Final[tuple]
    range_max: Final[float]
    range_min: Final[float]
    rate_hz: Final[float]
    topic: Final[str]

class Bumper:
    collision_names: Final[list[str]]
    frame: Final[str]
    name: Final[str]
    rate_hz: Final[float]
    topic: Final[str]

class CameraEye:
    far: Final[float]
    focal_x: Final[float]
    focal_y: Final[float]
    height: Final[int]
    middle_x: Final[float]
    middle_y: Final[float]
    name: Final[str]
    near: Final[float]
    pose: Final[tuple]
    width: Final[int]

class Car:
    base_frame: Final[str]
    bumpers: Final[list[Bumper]]
    cameras: Final[dict[str, list[CameraEye]]]
    components: Final[dict[str, dict[str, int]]]
    extent: Final[tuple]
    joints: Final[list[str]]
    lidars: Final[list[Lidar]]
    links: Final[list[str]]
    name: Final[str]
    odometry_topic: Final[str | None]
    parameters: Final[VehicleParameters]
    plugins: Final[list[str]]
    takes_steering_angle: Final[bool]
    track_width: Final[float]
    twist_topic: Final[str | None]
    warnings: Final[list[str]]
    wheel_radius: Final[float]

class CarState:
    a_x: Final[float]
    a_y: Final[float]
    steering_angle: Final[float]
    v_x: Final[float]
    v_y: Final[float]
    wheel_angles: Final[list[float]]
    wheel_speeds: Final[list[float]]
    x: Final[float]
    y: Final[float]
    yaw: Final[float]
    yaw_rate: Final[float]

class WheelOdometry:
    speed: Final[float]
    x: Final[float]
    y: Final[float]
    yaw: Final[float]
    yaw_rate: Final[float]

class Contact:
    depths: Final[list[float]]
    force: Final[tuple]
    normals: Final[NDArray[float64]]
    other_collision: Final[str]
    other_model: Final[str]
    own_collision: Final[str]
    positions: Final[NDArray[float64]]
    speed: Final[float]
    torque: Final[float]

class Snapshot: ...

class Simulation:
    def __init__(
        self, world: World, physics_step: float = ..., seed: int = ..., control_period: float = ...
    ) -> None: ...
    def add_car(
        self,
        car: Car,
        parameters: VehicleParameters | None = ...,
        x: float = ...,
        y: float = ...,
        yaw: float = ...,
    ) -> int: ...
    def add_model(self, model: Model) -> None: ...
    def advance_to(self, time: float) -> None: ...
    def car(self, car: int) -> Car: ...
    def cast_rays(
        self,
        car: int,
        directions: NDArray[float64],
        x: float = ...,
        y: float = ...,
        height: float = ...,
        yaw: float = ...,
        range_max: float = ...,
    ) -> NDArray[float64]: ...
    def clear_contacts(self, car: int) -> None: ...
    def clearance(self, car: int, limit: float = ...) -> float: ...
    def command(self, car: int, speed: float, steering_angle: float) -> None: ...
    def command_twist(self, car: int, linear_x: float, angular_z: float, linear_y: float = ...) -> None: ...
    def contacts(self, car: int) -> list[Contact]: ...
    def look(self, car: int, camera: str, eye: str = ...) -> tuple[NDArray[uint8], NDArray[float32]]: ...
    def model_names(self) -> list[str]: ...
    def model_pose(self, name: str) -> tuple: ...
    def parameters(self, car: int) -> VehicleParameters: ...
    def place_car(
        self,
        car: int,
        x: float,
        y: float,
        yaw: float,
        v_x: float = ...,
        v_y: float = ...,
        yaw_rate: float = ...,
    ) -> None: ...
    def place_model(
        self,
        name: str,
        x: float,
        y: float,
        yaw: float,
        v_x: float = ...,
        v_y: float = ...,
        yaw_rate: float = ...,
    ) -> None: ...
    def poses(self) -> NDArray[float64]: ...
    def remove_car(self, car: int) -> None: ...
    def remove_model(self, name: str) -> None: ...
    def reset(self) -> None: ...
    def restore(self, snapshot: Snapshot) -> None: ...
    def sample(self, car: int, component: str) -> dict[str, NDArray[float64]]: ...
    def scan(
        self, car: int, lidar: int = ..., out: NDArray[float32] | None = ..., exact: bool = ...
    ) -> NDArray[float32]: ...
    def scans(
        self, lidar: int = ..., out: NDArray[float32] | None = ..., exact: bool = ...
    ) -> NDArray[float32]: ...
    def snapshot(self) -> Snapshot: ...
    def state(self, car: int) -> CarState: ...
    def step(self) -> None: ...
    def trajectory_hash(self) -> str: ...
    def wheel_odometry(self, car: int) -> WheelOdometry: ...
    cars: Final[list[int]]
    time: Final[float]
    view_warning: Final[str]

class Course:
    def __init__(self, points: NDArray[float64]) -> None: ...
    def locate(self, x: float, y: float, yaw: float = ...) -> tuple: ...
    def pose(self, distance: float, offset: float = ...) -> tuple: ...
    length: Final[float]

class Episode: ...

class Environments:
    def __init__(
        self,
        world: World,
        cars: list[Car],
        course: Course | None,
        observation: list[str],
        actions: str = ...,
        period: float = ...,
        physics_step: float = ...,
        count: int = ...,
        threads: int = ...,
    ) -> None: ...
    def look(self, index: int, car: int) -> tuple[NDArray[uint8], NDArray[float32]]: ...
    def record(self, index: int, file: str) -> None: ...
    def reset(
        self,
        index: int,
        seed: int,
        parameters: list[VehicleParameters],
        starts: NDArray[float64],
        lidar_noise: list[float],
    ) -> None: ...
    def restore(self, index: int, episode: Episode) -> None: ...
    def snapshot(self, index: int) -> Episode: ...
    def step(self, actions: NDArray[float64], driven: NDArray[bool_]) -> None: ...
    bounds: Final[list[tuple[float, float]]]
    observations: Final[NDArray[float32]]
    part_sizes: Final[list[int]]
    results: Final[NDArray[Any]]
    times: Final[NDArray[float64]]

def empty_world() -> World: ...
def load_car(xml: str, name: str, source: str) -> Car: ...
def load_model(
    xml: str,
    name: str,
    source: str,
    x: float = ...,
    y: float = ...,
    z: float = ...,
    yaw: float = ...,
) -> list[Model]: ...
def load_world(path: str | PathLike[str], model_path: list[str] | None = ...) -> World: ...
def read_map(path: str | PathLike[str]) -> tuple[NDArray[int8], float, tuple[float, float, float]]: ...
def read_centreline(path: str | PathLike[str]) -> NDArray[float64]: ...
