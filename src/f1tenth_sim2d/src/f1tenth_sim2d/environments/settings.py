"""The settings of an environment."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from numbers import Integral, Real
from os import PathLike
from typing import Callable, Optional, Union

from f1tenth_sim2d import VehicleParameters

Range = Union[float, tuple[float, float]]
"""A number, or (least, greatest) of one that is drawn anew for each episode."""

SPEED_LIMIT = 100.0  # m/s, of commands; a simulation refuses more
PICTURES = ("camera", "depth")
"""Parts of an observation that a camera makes."""
_STARTS = ("grid", "random")
_ACTIONS = ("speed", "acceleration")


@dataclass(frozen=True)
class Settings:
    """Keywords of the environments. Units are SI's."""

    place: Union[str, PathLike]
    """name of a circuit, or the path of a .world file or of a map's .yaml file"""
    cars: int = 1
    """on the road; the first one is the ego car"""
    observation: Sequence[str] = ("scan", "velocity", "steering")
    """parts of what a car observes: scan, pose, velocity, steering, course, laps, contact, others,
    camera, depth, and names of its components: imu"""
    flatten: bool = False
    """one array instead of a dictionary of the parts"""
    actions: str = "speed"
    """speed: (steering angle, speed); acceleration: (steering rate, acceleration)"""
    normalized: bool = True
    """actions from -1 to 1 for what the car can do, instead of rad, m/s, rad/s, m/s^2"""
    speeds: Optional[tuple[float, float]] = None
    """m/s, least and greatest that an action asks for; default: what the car can do"""
    period: float = 0.025
    """s, of an action"""
    physics_step: float = 0.001
    """s"""
    beams: int = 108
    """of the lidar"""
    field_of_view: float = math.radians(270.0)
    """rad, of the lidar"""
    range_max: float = 10.0
    """m, of the lidar"""
    lidar_noise: Range = 0.01
    """m, standard deviation of a range"""
    vehicle: Mapping[str, Union[str, Range]] = field(default_factory=dict)
    """numbers of VehicleParameters that differ from the car's, for example {"mu": (0.8, 1.1)}"""
    start: str = "grid"
    """grid: at the start line, two abreast; random: anywhere along the course"""
    laps: Optional[int] = None
    """after which a car has finished; default: it drives on"""
    max_time: float = 60.0
    """s, after which an episode is cut off"""
    contact_ends: bool = True
    """whether a car that touches something has finished"""
    contact_penalty: float = 1.0
    """what a step with a contact costs"""
    reward: Optional[Callable] = None
    """of a car's results, see Environments.results; default: progress, m, less the penalty of contacts"""

    def __post_init__(self):
        """Raise ValueError for what is not allowed."""
        require_number("cars", self.cars, 1, 64, int)
        for name in ("flatten", "normalized", "contact_ends"):
            _require_one_of(name, getattr(self, name), (True, False))
        if isinstance(self.observation, str) or not self.observation:
            raise ValueError(f"observation: found {self.observation!r}, allowed is a list of names of parts")
        if len(set(self.observation)) != len(self.observation):
            raise ValueError(f"observation: found {list(self.observation)}, allowed is each part once")
        if self.flatten and set(PICTURES) & set(self.observation):
            raise ValueError("flatten: found True, allowed is False for observations with camera or depth")
        _require_one_of("actions", self.actions, _ACTIONS)
        _require_one_of("start", self.start, _STARTS)
        require_number("physics_step", self.physics_step, 1e-5, 0.02)
        require_number("period", self.period, self.physics_step, 10.0)
        require_number("beams", self.beams, 2, 100_000, int)
        require_number("field_of_view", self.field_of_view, 1e-6, 6.2832)
        require_number("range_max", self.range_max, 0.1, 1000.0)
        require_number("max_time", self.max_time, self.period, 1e6)
        require_number("contact_penalty", self.contact_penalty, 0.0, 1e6)
        if self.laps is not None:
            require_number("laps", self.laps, 1, 10**6, int)
        if self.speeds is not None:
            _require_pair("speeds", self.speeds, -SPEED_LIMIT, SPEED_LIMIT)
        _require_range("lidar_noise", self.lidar_noise, 0.0)
        if self.reward is not None and not callable(self.reward):
            raise ValueError(f"reward: found {self.reward!r}, allowed is a function of a car's results")
        if not isinstance(self.vehicle, Mapping):
            raise ValueError(
                f"vehicle: found {self.vehicle!r}, allowed are keys with numbers or (least, greatest)"
            )
        for name, value in self.vehicle.items():
            self._require_vehicle(name, value)

    @staticmethod
    def _require_vehicle(name, value):
        default = getattr(VehicleParameters(), name, None)
        if isinstance(default, str):
            if not isinstance(value, str):
                raise ValueError(f"vehicle[{name!r}]: found {value!r}, allowed is a name")
            return
        if not isinstance(default, float) or name == "wheelbase":
            raise ValueError(f"vehicle: unknown key {name!r}, allowed are {', '.join(vehicle_keys())}")
        _require_range(f"vehicle[{name!r}]", value)


def vehicle_keys():
    """Names of the numbers of VehicleParameters."""
    defaults = VehicleParameters()
    return [
        name
        for name in dir(defaults)
        if not name.startswith("_")
        and isinstance(getattr(defaults, name), (float, str))
        and name != "wheelbase"
    ]


def require_number(name, value, least, greatest, kind: type = Real):
    """Raise ValueError unless the value is a number of the kind, from least to greatest."""
    is_kind = isinstance(value, Integral if kind is int else kind) and not isinstance(value, bool)
    if not is_kind or not least <= value <= greatest:
        what = "a whole number" if kind is int else "a number"
        raise ValueError(f"{name}: found {value!r}, allowed is {what} from {least} to {greatest}")


def _require_one_of(name, value, allowed):
    if value not in allowed:
        raise ValueError(f"{name}: found {value!r}, allowed are {', '.join(map(str, allowed))}")


def _require_pair(name, value, least, greatest):
    if not _is_pair(value, least) or value[1] > greatest:
        raise ValueError(f"{name}: found {value!r}, allowed is (least, greatest), from {least} to {greatest}")


def _require_range(name, value, least=-math.inf):
    if not _is_pair(value if isinstance(value, (tuple, list)) else (value, value), least):
        above = "" if least == -math.inf else f" from {least}"
        raise ValueError(f"{name}: found {value!r}, allowed is a number{above} or (least, greatest)")


def _is_pair(value, least):
    """Whether it is (least, greatest), of finite numbers."""
    if not isinstance(value, (tuple, list)) or len(value) != 2:
        return False
    numbers = all(isinstance(each, Real) and not isinstance(each, bool) for each in value)
    return numbers and all(map(math.isfinite, value)) and least <= value[0] <= value[1]
