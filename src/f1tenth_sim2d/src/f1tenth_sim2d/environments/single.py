"""The environment of one driver."""

import gymnasium
import numpy as np

from f1tenth_sim2d.environments.shown import ShownEnv
from f1tenth_sim2d.environments.stage import repeated
from f1tenth_sim2d.environments.view import View


class F1TenthEnv(ShownEnv, gymnasium.Env):
    """Drives the cars of one simulation.

    With one car, observation and action are that car's; with several, they have one more axis in front, for
    the cars, and reward and end are those of the first one, the ego car.

    The info has the results of the cars by their names (arrays of shape (cars,), see Environments.results),
    the simulated time, s, and after a step the rewards of all cars.
    """

    metadata = {"render_modes": list(View.MODES), "render_fps": View.FRAMES_PER_SECOND}

    def __init__(self, render_mode=None, record=None, watch=False, **settings):
        """Load the place; see f1tenth_sim2d.environments.settings.Settings for what there is to choose.

        Args:
            render_mode: None, rgb_array or human.
            record: folder for all episodes, and, when the environment is closed, for the report of them.
            watch: print an address at which browsers of this machine show the episode in progress.
            settings: Settings.

        Raises:
            ValueError: settings that are not allowed.
            f1tenth_sim2d.LoadError: a place that cannot be used.
        """
        super().__init__(render_mode, record, watch, settings)
        self._cars = self._stage.settings.cars
        self.observation_space = repeated(self._stage.car_space, self._cars)
        self.action_space = repeated(self._stage.action_space, self._cars)
        self._driven = np.ones((1, self._cars), dtype=bool)
        self._begun = False

    def reset(self, *, seed=None, options=None):
        """Begin an episode.

        Args:
            seed: of all random draws from now on.
            options: both optional: {"poses": array of shape (cars, 3), x, y, yaw, where the cars start;
                "noise_seed": of the sensors}.

        Raises:
            ValueError: unknown options, a start that is not free, or a closed environment.
        """
        self._require_open()
        super().reset(seed=seed)
        self._begin(self.np_random, options)
        self._begun = True
        return self._observation(), self._stage.info(0)

    def step(self, action):
        """Drive for one period.

        Raises:
            ValueError: an action of another shape or not finite, no reset before, or a closed environment.
        """
        self._require_open()
        if not self._begun:
            raise ValueError("step before the first reset, which is not allowed")
        action = np.asarray(action, dtype=np.float64)
        if action.shape != self.action_space.shape:
            raise ValueError(f"action: found shape {action.shape}, allowed is {self.action_space.shape}")
        self._stage.step(action.reshape(1, self._cars, 2), self._driven)
        self._show()
        rewards = self._stage.rewards()[0]
        finished, late = bool(self._stage.finished()[0, 0]), bool(self._stage.out_of_time()[0])
        if self._recorder:
            self._recorder.note(finished or late)
        info = self._stage.info(0)
        info["rewards"] = rewards
        return self._observation(), float(rewards[0]), finished, late, info

    def _observation(self):
        return self._stage.observation((0, 0) if self._cars == 1 else 0)
