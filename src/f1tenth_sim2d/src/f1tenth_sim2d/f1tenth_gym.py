"""F110Env of f1tenth_gym 1.0 over this simulator; docs/coming_from_f1tenth_gym.md says what differs."""

from pathlib import Path
from typing import Any, Optional

import gymnasium
import numpy as np

from f1tenth_sim2d import f110_env
from f1tenth_sim2d.f1tenth_gym_names import PER_CAR
from f1tenth_sim2d.f1tenth_gym_track import Track, track_of

IDS = ("f1tenth_gym:f1tenth-v0", "f1tenth-v0")
_SETTINGS = ("map", "map_ext", "num_agents", "timestep", "params", "seed", "ego_idx", "integrator")
_MODELS = {"st": "single_track", "ks": "kinematic"}
_CONTROLS = (["speed", "steering_angle"], ["steering_angle", "speed"], ["speed"], "speed")
_KINEMATIC = ("pose_x", "pose_y", "delta", "linear_vel_x", "pose_theta")
_DYNAMIC = (*_KINEMATIC, "ang_vel_z", "beta")
_OBSERVATIONS = {
    "original": None,
    "kinematic_state": _KINEMATIC,
    "dynamic_state": _DYNAMIC,
    "frenet_dynamic_state": (*_DYNAMIC, "linear_vel_y"),
}
_FEATURES = (*PER_CAR, "delta", "beta")


class F110Env(f110_env.F110Env, gymnasium.Env):
    """Cars on a map, with the config and the five-value step of f1tenth_gym 1.0.

    Attributes:
        agent_ids: agent_0, agent_1, …
        render_mode: as given.
        action_space: of shape (num_agents, 2): steering angle, rad, and speed, m/s.
    """

    metadata = {"render_modes": ["human", "human_fast", "rgb_array"], "render_fps": 100}

    def __init__(self, config: dict[str, Any], render_mode: Optional[str] = None):
        """Load the map.

        Args:
            config: as f1tenth_gym's; `map` is the name of a circuit or the path of a map's .yaml file.
            render_mode: None, human, human_fast or rgb_array.

        Raises:
            ValueError: something that is not allowed, or an unknown key.
            f1tenth_sim2d.LoadError: a map that cannot be used.
        """
        config = dict(config)
        self._features = _features(config.pop("observation_config", None) or {})
        if "random" in str((config.pop("reset_config", None) or {}).get("type")):
            self._start = "random"
        self._vehicle = {"model": _MODELS[_choice("model", config.pop("model", "st"), tuple(_MODELS))]}
        _choice("control_input", config.pop("control_input", "speed"), _CONTROLS)
        _choice("render_mode", render_mode, (None, "human", "human_fast", "rgb_array"))
        for key in config:
            if key not in _SETTINGS:
                allowed = ", ".join(
                    (*_SETTINGS, "model", "control_input", "observation_config", "reset_config")
                )
                raise ValueError(f"config: unknown key {key!r}, allowed are {allowed}")
        self.render_mode = render_mode
        if render_mode == "rgb_array":
            self._view_mode = render_mode
        super().__init__(**config)
        self.agent_ids = [f"agent_{car}" for car in range(self.num_agents)]
        car = self._now.stage.action_space
        low, high = (np.tile(limit, (self.num_agents, 1)) for limit in (car.low, car.high))
        self.action_space = gymnasium.spaces.Box(low, high)

    @property
    def track(self) -> Track:
        """Centreline and raceline of the map of the next reset, from the files beside it."""
        map_file = Path(self.map_name)
        raceline = map_file.with_name(map_file.name.removesuffix("_map") + "_raceline.csv")
        return track_of(self._next.stage.place, raceline)

    def reset(self, poses=None, *, seed=None, options=None):
        """Put the cars somewhere and simulate a timestep.

        Args:
            poses: as options["poses"].
            seed: of the noise and of random starts from now on.
            options: {"poses": array of shape (num_agents, 3): x, y, theta, m and rad}; without them the cars
                stand at the start line, or anywhere if the type of `reset_config` is a random one.

        Returns:
            The observation and {"checkpoint_done": which cars have finished}.

        Raises:
            ValueError: another shape, or a place that is not free.
        """
        if seed is not None:
            self.seed = seed
        poses = (options or {}).get("poses", poses)
        observation, _, _, info = super().reset(self._drawn_start() if poses is None else poses)
        return self._observed(observation), info

    def step(self, action):
        """Drive for a timestep; as in f1tenth_sim2d.f110_env, with `truncated` (False) before the info."""
        observation, reward, done, info = super().step(action)
        return self._observed(observation), reward, done, False, info

    def render(self, mode=None):
        """Show the cars as render_mode says; rgb_array returns the picture."""
        if self.render_mode is not None:
            self._now.view.show()
        return self._now.view.render()

    def _drawn_start(self):
        """Poses of the centres of mass, by the rules of F1Tenth-v0."""
        stage = self._next.stage
        stage.begin(0, np.random.default_rng(self.seed), {"noise_seed": self.seed})
        cars, rear = stage.results[0], self._next.rear
        ahead = np.column_stack([np.cos(cars["yaw"]), np.sin(cars["yaw"])])
        return np.column_stack([cars["x"], cars["y"], cars["yaw"]]) + np.pad(rear * ahead, ((0, 0), (0, 1)))

    def _observed(self, observation):
        if self._features is None:
            return {
                key: value if key == "ego_idx" else np.array(value, dtype=np.float32)
                for key, value in observation.items()
            }
        values = {feature: observation[key] for feature, key in PER_CAR.items()}
        values["delta"] = self._now.stage.results[0]["steering_angle"]
        values["beta"] = np.arctan2(observation["linear_vels_y"], observation["linear_vels_x"])
        return {
            agent: {feature: np.float32(values[feature][car]) for feature in self._features}
            for car, agent in enumerate(self.agent_ids)
        }


def _features(config):
    """Features of a car that are observed; None for the original observation."""
    kind = config.get("type") or "original"
    if kind == "features":
        for feature in config.get("features", ()):
            _choice("observation_config: features", feature, _FEATURES)
        return tuple(config.get("features", _FEATURES))
    return _OBSERVATIONS[_choice("observation_config: type", kind, (*_OBSERVATIONS, "features"))]


def _choice(name, value, allowed):
    if value not in allowed:
        raise ValueError(f"{name}: found {value!r}, allowed are {', '.join(str(each) for each in allowed)}")
    return value
