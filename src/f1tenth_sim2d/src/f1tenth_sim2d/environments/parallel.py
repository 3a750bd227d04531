"""The environment of several drivers, as PettingZoo has it."""

import warnings

import numpy as np
from gymnasium.utils import seeding
from pettingzoo import ParallelEnv

from f1tenth_sim2d.environments.car import numbered_agents
from f1tenth_sim2d.environments.episode import OPTIONS
from f1tenth_sim2d.environments.shown import ShownEnv
from f1tenth_sim2d.environments.view import View


class F1TenthParallelEnv(ShownEnv, ParallelEnv):
    """Several cars on one road, each with a driver of its own: car_0, car_1, ….

    A car that has driven its laps or touched something loses its driver; it stops and stays where it is.
    """

    metadata = {
        "name": "F1Tenth-v0",
        "render_modes": list(View.MODES),
        "render_fps": View.FRAMES_PER_SECOND,
        "is_parallelizable": True,
    }

    def __init__(self, render_mode=None, record=None, watch=False, **settings):
        """Load the place; arguments and errors as of F1TenthEnv, but with two cars unless told."""
        super().__init__(render_mode, record, watch, {"cars": 2, **settings}, numbered_agents)
        self.possible_agents = [car.name for car in self._stage.cars]
        self.agents: list = []
        self.observation_spaces = dict.fromkeys(self.possible_agents, self._stage.car_space)
        self.action_spaces = dict.fromkeys(self.possible_agents, self._stage.action_space)
        self._rng, _ = seeding.np_random()

    def observation_space(self, agent):
        """Space of what a car observes."""
        return self.observation_spaces[agent]

    def action_space(self, agent):
        """Space of the actions of a car."""
        return self.action_spaces[agent]

    def reset(self, seed=None, options=None):
        """Begin an episode; seed and options as of F1TenthEnv.reset.

        Unknown options only cause a warning, because PettingZoo's own test gives one.

        Raises:
            ValueError: wrong options, a start that is not free, or a closed environment.
        """
        self._require_open()
        if seed is not None:
            self._rng, _ = seeding.np_random(seed)
        self._begin(self._rng, _known(options or {}))
        self.agents = list(self.possible_agents)
        return self._of_agents(self._observe), self._of_agents(self._info)

    def step(self, actions):
        """Drive for one period; actions are those of the cars in `agents`.

        Raises:
            ValueError: a car without action or an action without car, a wrong shape, a value that is not
                finite, or a closed environment; nothing has moved then.
        """
        self._require_open()
        if set(actions) != set(self.agents):
            raise ValueError(f"actions: found those of {sorted(actions)}, allowed are those of {self.agents}")
        if not self.agents:
            return {}, {}, {}, {}, {}
        driven = np.array([[agent in self.agents for agent in self.possible_agents]])
        self._stage.step(self._rows(actions), driven)
        self._show()
        rewards, finished = self._stage.rewards()[0], self._stage.finished()[0]
        late = bool(self._stage.out_of_time()[0])
        answer = (
            self._of_agents(self._observe),
            self._of_agents(lambda i: float(rewards[i])),
            self._of_agents(lambda i: bool(finished[i])),
            self._of_agents(lambda _: late),
            self._of_agents(self._info),
        )
        self.agents = [agent for agent in self.agents if not (late or answer[2][agent])]
        if self._recorder:
            self._recorder.note(not self.agents)
        return answer

    def _rows(self, actions):
        rows = np.zeros((1, len(self.possible_agents), 2))
        for i, agent in enumerate(self.possible_agents):
            if agent in actions:
                action = np.asarray(actions[agent], dtype=np.float64)
                if action.shape != (2,):
                    raise ValueError(f"actions[{agent!r}]: found shape {action.shape}, allowed is (2,)")
                rows[0, i] = action
        return rows

    def _of_agents(self, value):
        return {agent: value(self.possible_agents.index(agent)) for agent in self.agents}

    def _observe(self, index):
        return self._stage.observation((0, index))

    def _info(self, index):
        return self._stage.info(0, index)


def _known(options):
    unknown = sorted(set(options) - set(OPTIONS))
    if unknown:
        warnings.warn(f"options: found {unknown}, allowed are {', '.join(OPTIONS)}", stacklevel=3)
    return {key: options[key] for key in OPTIONS if key in options}
