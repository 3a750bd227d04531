"""Many environments, stepped together in C++."""

import os

import numpy as np
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from f1tenth_sim2d.environments.recording import watch_of
from f1tenth_sim2d.environments.settings import require_number
from f1tenth_sim2d.environments.stage import Stage, repeated


class F1TenthVectorEnv(VectorEnv):
    """Environments that share one world and are stepped by several threads.

    Environment i, reset with seed s, does what a single one reset with seed s + i does, bit for bit,
    however many there are. One that has ended begins anew in the step after (AutoresetMode.NEXT_STEP).

    The info has the results of the cars by their names (arrays of shape (num_envs, cars), see
    Environments.results), the simulated times, s, and the rewards of all cars.
    """

    metadata = {"render_modes": [], "autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(self, num_envs=1, threads=None, render_mode=None, watch=False, **settings):
        """Load the place; settings and errors are those of F1TenthEnv.

        Args:
            num_envs: how many environments.
            threads: that step them; default: one per available processor.
            render_mode: None; these environments draw no pictures.
            watch: as of F1TenthEnv; shown is the first environment.
            settings: Settings.
        """
        threads = len(os.sched_getaffinity(0)) if threads is None else threads
        for name, value in (("num_envs", num_envs), ("threads", threads)):
            require_number(name, value, 1, 100_000, int)
        if render_mode is not None:
            raise ValueError(f"render_mode: found {render_mode!r}, allowed is None")
        self.render_mode = None
        self._stage = Stage(settings, num_envs, threads)
        self._watch = watch_of(watch, self._stage)
        cars = self._stage.settings.cars
        self.num_envs = num_envs
        self.single_observation_space = repeated(self._stage.car_space, cars)
        self.single_action_space = repeated(self._stage.action_space, cars)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._rngs = [seeding.np_random()[0] for _ in range(num_envs)]
        self._ended = np.zeros(num_envs, dtype=bool)
        self._begun = np.zeros(num_envs, dtype=bool)

    def reset(self, *, seed=None, options=None):
        """Begin an episode of all, or of those that options["reset_mask"] names.

        Args:
            seed: int, the first one's, or a list of one per environment (None: its random draws continue).
            options: as of F1TenthEnv.reset; "reset_mask" is a bool array of shape (num_envs,).

        Raises:
            ValueError: another number of seeds, unknown options, a start that is not free, or a closed
                environment.
        """
        self._require_open()
        options = dict(options or {})
        mask = self._mask(options.pop("reset_mask", None))
        for i, each in enumerate(self._seeds(seed)):
            if mask[i] and each is not None:
                self._rngs[i], _ = seeding.np_random(each)
        for i in np.flatnonzero(mask):
            self._begin(int(i), options)
            self._ended[i], self._begun[i] = False, True
        return self._observation(), self._info(self._stage.rewards())

    def step(self, actions):
        """Drive all for one period, but begin an episode of those that ended in the step before.

        Raises:
            ValueError: actions of another shape or not finite, an environment without a reset before, or a
                closed one.
        """
        self._require_open()
        if not self._begun.all():
            waiting = ", ".join(map(str, np.flatnonzero(~self._begun)))
            raise ValueError(f"step before the first reset of environments {waiting}, which is not allowed")
        actions = np.asarray(actions, dtype=np.float64)
        if actions.shape != self.action_space.shape:
            raise ValueError(f"actions: found shape {actions.shape}, allowed is {self.action_space.shape}")
        restarted = self._ended
        driven = np.repeat(~restarted[:, None], self._stage.settings.cars, axis=1)
        self._stage.step(actions.reshape(*driven.shape, 2), driven)
        if self._watch and not restarted[0]:
            self._watch.note()
        for i in np.flatnonzero(restarted):
            self._begin(int(i))
        all_rewards = np.where(restarted[:, None], 0.0, self._stage.rewards())
        finished = self._stage.finished()[:, 0] & ~restarted
        late = self._stage.out_of_time() & ~restarted
        self._ended = finished | late
        return self._observation(), all_rewards[:, 0].copy(), finished, late, self._info(all_rewards)

    def close_extras(self, **_):
        """Release everything."""
        del self._stage
        if self._watch:
            self._watch.close()

    def _begin(self, i, options=None):
        self._stage.begin(i, self._rngs[i], options)
        if i == 0 and self._watch:
            self._watch.begin()

    def _observation(self):
        return self._stage.observation((slice(None), 0) if self._stage.settings.cars == 1 else slice(None))

    def _info(self, rewards):
        return {**self._stage.info(slice(None)), "rewards": rewards}

    def _seeds(self, seed):
        if seed is None:
            return [None] * self.num_envs
        if isinstance(seed, (int, np.integer)):
            return [int(seed) + i for i in range(self.num_envs)]
        if len(seed) != self.num_envs:
            raise ValueError(f"seed: found {len(seed)} seeds, allowed are {self.num_envs}")
        return list(seed)

    def _mask(self, mask):
        if mask is None:
            return np.ones(self.num_envs, dtype=bool)
        mask = np.asarray(mask)
        if mask.dtype != bool or mask.shape != (self.num_envs,):
            raise ValueError(
                f"reset_mask: found {mask!r}, allowed is a bool array of shape ({self.num_envs},)"
            )
        return mask

    def _require_open(self):
        if self.closed:
            raise ValueError("the environment is closed")
