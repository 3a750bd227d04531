"""F110Env of f1tenth_gym, as it was before Gymnasium, over this simulator.

docs/coming_from_f1tenth_gym.md says what differs.
"""

import enum
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from f1tenth_sim2d import VehicleParameters
from f1tenth_sim2d.environments.place import circuits
from f1tenth_sim2d.environments.settings import require_number
from f1tenth_sim2d.environments.stage import Stage
from f1tenth_sim2d.environments.view import View

_NUMBERS = {
    "mu": "mu",
    "C_Sf": "C_Sf",
    "C_Sr": "C_Sr",
    "lf": "l_f",
    "lr": "l_r",
    "h": "h",
    "m": "m",
    "I": "I_z",
    "s_max": "steering_max",
    "sv_max": "steering_rate_max",
    "v_switch": "v_switch",
    "a_max": "a_max",
    "v_min": "v_min",
    "v_max": "v_max",
}
"""Their names of what VehicleParameters has."""
_MIRRORED = {"s_min": "s_max", "sv_min": "sv_max"}
_SHAPE = {"length": 0.58, "width": 0.31}  # m, of the car's description
_LIDAR = {"beams": 1080, "field_of_view": 4.7, "range_max": 30.0, "lidar_noise": 0.01}
_LAPS = 2  # after which a car has finished
_ZONE = 0.1**0.5  # m, around the start line
_HALF_LINE = 2.0  # m, from where a car started


class Integrator(enum.Enum):
    """That of f1tenth_gym. It makes no difference here: physics has its own steps of 1 ms."""

    RK4 = 1
    Euler = 2


@dataclass(frozen=True)
class _Loaded:
    """What an episode is driven with."""

    stage: Stage
    view: View
    rear: float  # m, from the rear axle to the centre of mass


class F110Env:
    """Cars on a map, with the names and the four-value step of f1tenth_gym.

    Poses are those of the centre of mass. An episode ends when the ego car touches something or every car
    has driven two laps: it has left the start line and come back to it twice.

    Attributes:
        map_name, num_agents, timestep, ego_idx, seed, params: as given; map_name without .yaml.
        current_time: s.
        lap_times, lap_counts: arrays of shape (num_agents,).
    """

    _view_mode, _start = "human", "grid"
    _vehicle: dict[str, str] = {}
    """Parameters of the cars that `params` does not have."""

    def __init__(
        self,
        map=None,
        map_ext=".png",
        num_agents=2,
        timestep=0.01,
        params=None,
        seed=12345,
        ego_idx=0,
        integrator=Integrator.RK4,
        **unknown,
    ):
        """Load the map.

        Args:
            map: path of a map's .yaml file, with or without .yaml, or the name of a circuit.
            map_ext: extension of the map's image file.
            num_agents: number of cars.
            timestep: s, of an action.
            params: parameters of the cars by name, those that differ from the workspace's car.
            seed: of the lidars' noise.
            ego_idx: index of the ego car.
            integrator: makes no difference.

        Raises:
            ValueError: something that is not allowed, or an unknown keyword.
            f1tenth_sim2d.LoadError: a map that cannot be used.
        """
        if unknown:
            allowed = "map, map_ext, num_agents, timestep, params, seed, ego_idx, integrator"
            raise ValueError(f"unknown keyword {min(unknown)!r}, allowed are {allowed}")
        require_number("num_agents", num_agents, 1, 64, int)
        require_number("timestep", timestep, 0.001, 1.0)
        require_number("seed", seed, 0, 2**63 - 1, int)
        require_number("ego_idx", ego_idx, 0, num_agents - 1, int)
        if map is None:
            raise ValueError(f"map: missing; f1tenth_gym's default 'vegas' is not here, {_allowed_maps()}")
        self.map_name, self._map_ext = str(map).removesuffix(".yaml"), map_ext
        self.num_agents, self.timestep = num_agents, timestep
        self.seed, self.ego_idx = seed, ego_idx
        self._now = self._next = self._load(_place(self.map_name, map_ext), dict(params or {}))
        self._starts: Any = None

    def reset(self, poses):
        """Put the cars somewhere and simulate a timestep.

        Args:
            poses: array of shape (num_agents, 3): x, y, theta, m and rad.

        Returns:
            as step.

        Raises:
            ValueError: another shape, or a place that is not free.
        """
        poses = np.array(poses, dtype=float)
        if poses.shape != (self.num_agents, 3):
            raise ValueError(f"poses: found shape {poses.shape}, allowed is {(self.num_agents, 3)}")
        behind = self._next.rear * np.column_stack([np.cos(poses[:, 2]), np.sin(poses[:, 2])])
        starts = np.column_stack([poses[:, :2] - behind, poses[:, 2]])
        options = {"poses": starts, "noise_seed": self.seed}
        self._next.stage.begin(0, np.random.default_rng(self.seed), options)
        if self._next is not self._now:
            self._now.view.close()
            self._now = self._next
        self._starts, self.current_time = poses, 0.0
        self._near = np.ones(self.num_agents, dtype=bool)
        self._toggles = np.zeros(self.num_agents)
        self.lap_times, self.lap_counts = np.zeros(self.num_agents), np.zeros(self.num_agents)
        return self._drive(np.zeros((self.num_agents, 2)))

    def step(self, action):
        """Drive for a timestep.

        Args:
            action: array of shape (num_agents, 2): steering angle, rad, and speed, m/s.

        Returns:
            The observation, the reward (the timestep), whether the episode is over, and {"checkpoint_done":
            which cars have finished}.

        Raises:
            ValueError: another shape, a value that is not finite, or no reset before.
        """
        return self._drive(action)

    def _drive(self, action):
        if self._starts is None:
            raise ValueError("step before the first reset, which is not allowed")
        action = np.asarray(action, dtype=float)
        if action.shape != (self.num_agents, 2):
            raise ValueError(f"action: found shape {action.shape}, allowed is {(self.num_agents, 2)}")
        self._now.stage.step(action[None], np.ones((1, self.num_agents), dtype=bool))
        self.current_time += self.timestep
        observation = self._observation()
        self._count_laps(observation["poses_x"], observation["poses_y"])
        observation.update(lap_times=self.lap_times.copy(), lap_counts=self.lap_counts.copy())
        finished = self._toggles >= 2 * _LAPS
        done = bool(observation["collisions"][self.ego_idx]) or bool(finished.all())
        return observation, self.timestep, done, {"checkpoint_done": finished}

    def update_map(self, map_path, map_ext):
        """Use another map from the next reset on, given the path of its .yaml file."""
        name = str(map_path).removesuffix(".yaml")
        self._next = self._load(_place(name, map_ext), self.params)
        self.map_name, self._map_ext = name, map_ext

    def update_params(self, params, index=-1):
        """Use other parameters for all cars from the next reset on.

        Raises:
            ValueError: as for params, or an index, because the cars are alike.
        """
        if index != -1:
            raise ValueError(f"index: found {index}, allowed is -1: all cars are alike")
        self._next = self._load(_place(self.map_name, self._map_ext), dict(params))

    def add_render_callback(self, callback_func):
        """Warn that it has no effect: callbacks draw with f1tenth_gym's own renderer."""
        warnings.warn(
            "add_render_callback: the callback is not called, pyglet is not used here", stacklevel=2
        )

    def render(self, mode="human"):
        """Show the cars in a window; mode is human or human_fast.

        Raises:
            ValueError: another mode.
        """
        if mode not in ("human", "human_fast"):
            raise ValueError(f"mode: found {mode!r}, allowed are human, human_fast")
        self._now.view.show()

    def close(self):
        """Close the window."""
        self._now.view.close()

    def _load(self, place, params):
        stage = Stage(
            {
                "place": place,
                "cars": self.num_agents,
                "observation": ("scan",),
                "normalized": False,
                "period": self.timestep,
                "vehicle": {**_vehicle(params), **self._vehicle},
                "start": self._start,
                **_LIDAR,
            }
        )
        self.params = params
        return _Loaded(stage, View(self._view_mode, stage), params.get("lr", VehicleParameters().l_r))

    def _observation(self):
        cars = self._now.stage.results[0]
        scans = self._now.stage.observation(0)["scan"].astype(float)
        return {
            "ego_idx": self.ego_idx,
            "scans": list(scans),
            "poses_x": list(cars["x"] + self._now.rear * np.cos(cars["yaw"])),
            "poses_y": list(cars["y"] + self._now.rear * np.sin(cars["yaw"])),
            "poses_theta": list(cars["yaw"] % (2 * np.pi)),
            "linear_vels_x": list(cars["v_x"]),
            "linear_vels_y": list(cars["v_y"] + self._now.rear * cars["yaw_rate"]),
            "ang_vels_z": list(cars["yaw_rate"]),
            "collisions": cars["contact"].copy(),
        }

    def _count_laps(self, x, y):
        """A car leaves the start line and comes back to it once per lap."""
        cosine, sine = np.cos(self._starts[self.ego_idx, 2]), np.sin(self._starts[self.ego_idx, 2])
        dx, dy = x - self._starts[:, 0], y - self._starts[:, 1]
        ahead = cosine * dx + sine * dy
        beside = np.maximum(0.0, np.abs(cosine * dy - sine * dx) - _HALF_LINE)
        near = np.hypot(ahead, beside) <= _ZONE
        self._toggles += near != self._near
        self._near = near
        self.lap_counts = self._toggles // 2
        self.lap_times = np.where(self._toggles < 2 * _LAPS, self.current_time, self.lap_times)


def _place(map, map_ext):
    if str(map) in circuits():
        return map
    if not Path(f"{map}.yaml").is_file():
        raise ValueError(f"map: found {str(map)!r}, {_allowed_maps()}")
    if not Path(f"{map}{map_ext}").is_file():
        raise ValueError(
            f"map_ext: found {map_ext!r}, allowed is the extension of an image beside {map}.yaml"
        )
    return f"{map}.yaml"


def _allowed_maps():
    return f"allowed are {', '.join(circuits())}, and paths of maps' .yaml files"


def _vehicle(params):
    """Values of VehicleParameters by our names."""
    for key, value in params.items():
        if key in _SHAPE:
            _require_equal(key, value, _SHAPE[key], "the shape is that of the car's description")
        elif key in _MIRRORED:
            opposite = _MIRRORED[key]
            greatest = params.get(opposite, getattr(VehicleParameters(), _NUMBERS[opposite]))
            _require_equal(key, value, -greatest, "the car steers alike to either side")
        elif key not in _NUMBERS:
            allowed = ", ".join((*_NUMBERS, *_MIRRORED, *_SHAPE))
            raise ValueError(f"params: unknown key {key!r}, allowed are {allowed}")
    return {_NUMBERS[key]: value for key, value in params.items() if key in _NUMBERS}


def _require_equal(key, value, allowed, why):
    if value != allowed:
        raise ValueError(f"params[{key!r}]: found {value!r}, allowed is {allowed}: {why}")
