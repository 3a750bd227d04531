"""What all environments are made of: a place, cars, and simulations of them."""

import copy
import dataclasses
from typing import Any

import numpy as np
from gymnasium import spaces

import f1tenth_sim2d
from f1tenth_sim2d.environments.car import Lidar, load_cars, numbered
from f1tenth_sim2d.environments.episode import begin_episode, draw
from f1tenth_sim2d.environments.place import find_place
from f1tenth_sim2d.environments.settings import PICTURES, SPEED_LIMIT, Settings


class Stage:
    """Simulations as the settings define them.

    Attributes:
        settings: Settings.
        place: Place.
        cars: descriptions of the cars of an environment, list of f1tenth_sim2d.Car.
        results: view of the results of the cars, structured array of shape (count, cars); see
            Environments.results.
        times: view of the simulated times, s, float64 array of shape (count,).
        car_space, action_space: of one car.
    """

    def __init__(self, settings: dict, count: int = 1, threads: int = 1, names=numbered):
        """Load the place and build `count` environments; raises what F1TenthEnv raises.

        `names` gives the names of a number of cars.
        """
        self.settings = _settings(settings)
        self.place = find_place(self.settings.place)
        self._require_course()
        lidar = Lidar(self.settings.beams, self.settings.field_of_view, self.settings.range_max)
        self.cars = load_cars(names(self.settings.cars), lidar)
        self._parameters = self.cars[0].parameters
        self._require_vehicle()
        self._require_speeds()
        self._made_with = (count, threads, names)
        self._has_begun = False
        self._environments = self._build(count, threads)
        self._view_memory()
        self.car_space = self._car_space()
        self._action_low, self._action_high = self._action_limits()
        self.action_space = self._action_space()

    def __deepcopy__(self, memo):
        """Return a stage whose episodes go on as these do, bit for bit.

        Raises:
            f1tenth_sim2d.Error: an episode is recorded.
        """
        other = Stage.__new__(Stage)
        other.__dict__.update(self.__dict__)
        other._environments = self._build(*self._made_with[:2])
        for index in range(self._made_with[0]):
            other._environments.restore(index, self._environments.snapshot(index))
        other._view_memory()
        return other

    def __reduce__(self):
        """For pickle: the settings.

        Raises:
            TypeError: an episode has begun; what it is made of has no form outside of memory.
        """
        if self._has_begun:
            raise TypeError(
                "an episode cannot be pickled: pickle the environment before its first reset, "
                "or copy it within the process with copy.deepcopy"
            )
        settings = {each.name: getattr(self.settings, each.name) for each in dataclasses.fields(Settings)}
        return Stage, (settings, *self._made_with)

    def _view_memory(self):
        self.results = self._environments.results
        # The same memory as plain numbers: fields of a structured array are slow to access.
        self._names = self.results.dtype.names
        self._numbers = self.results.view(np.float64).reshape(*self.results.shape, -1)
        columns = dict(zip(self._names, np.moveaxis(self._numbers, -1, 0)))
        self._progress, self._contact, self._laps = (
            columns[name] for name in ("progress", "contact", "laps")
        )
        self.times = self._environments.times

    def _require_course(self):
        needs = [part for part in ("course", "laps") if part in self.settings.observation]
        needs += ["start='random'"] if self.settings.start == "random" else []
        needs += ["laps"] if self.settings.laps is not None else []
        if needs and self.place.course is None:
            raise ValueError(
                f"{needs[0]}: {self.place.name} has no course, allowed are circuits, "
                "and worlds and maps with X_centerline.csv beside them"
            )

    def _require_vehicle(self):
        """Refuse parameters from which an episode could draw an impossible car."""
        for end in (0, 1):
            parameters = copy.copy(self._parameters)
            try:
                for name in self.settings.vehicle:
                    setattr(parameters, name, self._drawn(name)[end])
                f1tenth_sim2d.Simulation(f1tenth_sim2d.empty_world()).add_car(self.cars[0], parameters)
            except f1tenth_sim2d.Error as error:
                raise ValueError(f"vehicle: {error}") from error

    def _require_speeds(self):
        """Refuse parameters with which an action could ask for a speed that a simulation refuses."""
        lead, what = 0.0, ""
        if self.settings.actions == "acceleration":
            lead, what = self._drawn("a_max")[1] / self._drawn("speed_gain")[0], " + a_max / speed_gain"
        elif self.settings.speeds is not None:
            return
        for name, fastest in (("v_max", self._drawn("v_max")[1]), ("-v_min", -self._drawn("v_min")[0])):
            if fastest + lead > SPEED_LIMIT:
                raise ValueError(
                    f"vehicle: an action can ask for {fastest + lead:g} m/s ({name}{what}), "
                    f"allowed is up to {SPEED_LIMIT:g} m/s"
                )

    def _build(self, count, threads):
        try:
            return f1tenth_sim2d.Environments(
                self.place.world,
                self.cars,
                self.place.course,
                [part for part in self.settings.observation if part not in PICTURES],
                actions=self.settings.actions,
                period=self.settings.period,
                physics_step=self.settings.physics_step,
                count=count,
                threads=threads,
            )
        except f1tenth_sim2d.Error as error:
            raise ValueError(str(error)) from error

    def draw_parameters(self, rng):
        """VehicleParameters for one episode."""
        parameters = copy.copy(self._parameters)
        for name, value in self.settings.vehicle.items():
            setattr(parameters, name, value if isinstance(value, str) else draw(rng, value))
        return parameters

    def begin(self, index: int, rng: np.random.Generator, options=None):
        """Begin an episode of one environment; see begin_episode."""
        begin_episode(self._environments, index, self, rng, options)
        self._has_begun = True

    def record(self, file):
        """Write what the cars of the first environment do; see Environments.record.

        Args:
            file: path of the CSV file, or None.
        """
        self._environments.record(0, str(file or ""))

    def step(self, actions, driven):
        """Drive for one period.

        Args:
            actions: of shape (count, cars, 2), as the action space says; values beyond its limits
                are clipped.
            driven: bool array of shape (count, cars), see Environments.step.

        Raises:
            ValueError: another shape, or an action that is not finite; nothing has moved then.
        """
        actions = np.asarray(actions, dtype=np.float64)
        if actions.shape != (*self.results.shape, 2):
            raise ValueError(f"action: found shape {actions.shape}, allowed is {(*self.results.shape, 2)}")
        if not np.isfinite(actions).all():
            raise ValueError("action: found a number that is not finite, allowed are finite ones")
        # Not np.clip, which takes several times as long.
        if self.settings.normalized:
            share = (np.minimum(np.maximum(actions, -1.0), 1.0) + 1.0) / 2.0
            actions = self._action_low + share * (self._action_high - self._action_low)
        else:
            actions = np.minimum(np.maximum(actions, self._action_low), self._action_high)
        try:
            self._environments.step(actions, driven)
        except f1tenth_sim2d.Error as error:
            raise ValueError(f"vehicle: {error}") from error

    def observation(self, index):
        """What is observed now, a copy.

        Args:
            index: into an array of shape (count, cars).
        """
        rows = self._environments.observations[index].copy()
        if self.settings.flatten:
            return rows
        return {**{part: rows[..., where] for part, where in self._parts()}, **self._pictures(index)}

    def _pictures(self, index):
        """What the first eyes of the cars' first cameras see, by the parts that show it."""
        parts = [part for part in PICTURES if part in self.settings.observation]
        if not parts:
            return {}
        _, cars = self.results.shape
        which = np.arange(self.results.size).reshape(self.results.shape)[index]
        looks = [self._environments.look(*divmod(int(each), cars)) for each in which.flat]
        seen = [np.stack(each) for each in zip(*looks)]
        seen = [each.reshape(*which.shape, *each.shape[1:]) for each in seen]
        return {part: seen[PICTURES.index(part)] for part in parts}

    def info(self, index, car=slice(None)):
        """What Gymnasium calls info, copies: the results by their names and the time, s.

        Args:
            index: of one environment, or a slice of them.
            car: index of one car, or a slice of them.
        """
        numbers = self._numbers[index, car].copy()
        last = numbers.ndim - 1
        info = dict(zip(self._names, numbers.transpose(last, *range(last))))
        info["time"] = self.times[index].copy()
        return info

    def rewards(self):
        """Of all cars: float64 array of shape (count, cars)."""
        if self.settings.reward is not None:
            return np.array([[float(self.settings.reward(car)) for car in row] for row in self.results])
        return self._progress - self.settings.contact_penalty * self._contact

    def finished(self):
        """Which cars have driven their laps or touched something: bool array of shape (count, cars)."""
        done = self._contact > (0.0 if self.settings.contact_ends else np.inf)
        if self.settings.laps is not None:
            done |= self._laps >= self.settings.laps
        return done

    def out_of_time(self):
        """Which environments have reached the end of their time: bool array of shape (count,)."""
        return self.times >= self.settings.max_time - self.settings.period / 2

    def _parts(self):
        end = 0
        numbers = [part for part in self.settings.observation if part not in PICTURES]
        for part, size in zip(numbers, self._environments.part_sizes):
            end += size
            yield part, slice(end - size, end)

    def _car_space(self):
        low, high = np.array(self._environments.bounds, dtype=np.float32).reshape(-1, 2).T
        if self.settings.flatten:
            return spaces.Box(low, high, dtype=np.float32)
        parts = {part: spaces.Box(low[at], high[at], dtype=np.float32) for part, at in self._parts()}
        return spaces.Dict({**parts, **self._picture_spaces()})

    def _picture_spaces(self):
        if not set(PICTURES) & set(self.settings.observation):
            return {}
        eye = next(iter(self.cars[0].cameras.values()))[0]
        size = (eye.height, eye.width)
        allowed = {
            "camera": spaces.Box(0, 255, (*size, 3), np.uint8),
            "depth": spaces.Box(0.0, np.inf, size, np.float32),
        }
        return {part: allowed[part] for part in PICTURES if part in self.settings.observation}

    def _action_limits(self):
        if self.settings.actions == "acceleration":
            rates = np.array([self._drawn("steering_rate_max")[1], self._drawn("a_max")[1]])
            return -rates, rates
        slowest, fastest = self.settings.speeds or (self._drawn("v_min")[0], self._drawn("v_max")[1])
        steering = self._drawn("steering_max")[1]
        return np.array([-steering, slowest]), np.array([steering, fastest])

    def _drawn(self, name):
        """The least and the greatest value that a parameter of the cars can have."""
        value = self.settings.vehicle.get(name, getattr(self._parameters, name))
        return value if isinstance(value, (tuple, list)) else (value, value)

    def _action_space(self):
        if self.settings.normalized:
            return spaces.Box(-1.0, 1.0, (2,), np.float32)
        return spaces.Box(
            self._action_low.astype(np.float32), self._action_high.astype(np.float32), dtype=np.float32
        )


def repeated(space: spaces.Space, cars: int) -> Any:
    """A space for all cars: with one more axis in front if there are several."""
    if cars == 1:
        return space
    if isinstance(space, spaces.Dict):
        return spaces.Dict({name: repeated(each, cars) for name, each in space.items()})
    assert isinstance(space, spaces.Box)
    return spaces.Box(np.stack([space.low] * cars), np.stack([space.high] * cars), dtype=space.dtype)


def _settings(given):
    allowed = [each.name for each in dataclasses.fields(Settings)]
    for key in given:
        if key not in allowed:
            raise ValueError(f"unknown setting {key!r}, allowed are {', '.join(allowed)}")
    if "place" not in given:
        raise ValueError(
            "place is missing: the name of a circuit, or the path of a .world or a map's .yaml file"
        )
    return Settings(**given)
