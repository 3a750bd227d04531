"""env_step_us, env_reset_ms, env_vector, env_many, env_steps: the environments to learn in."""

import os
import timeit

import numpy as np
from f1tenth_sim2d.environments import ENVIRONMENT, register

from f1tenth_bench.benchmark import Measured, NotAvailable, benchmark
from f1tenth_bench.places import data_file
from f1tenth_bench.timing import processor_seconds

STEPS = 300
REPEATS = 9
ENVIRONMENTS, THREADS, VECTOR_STEPS = 64, 2, 50
MANY, MANY_STEPS = 1024, 10
STANDSTILL = np.zeros(2, np.float32)
BEAMS, CARS = (1080, 270, 108), (1, 2, 8)


def _gymnasium():
    try:
        import gymnasium
    except ImportError as error:
        raise NotAvailable(f"{error}; make setup installs it") from error
    register()
    return gymnasium


def _make(**settings):
    """Make an environment without wrappers."""
    return _gymnasium().make(ENVIRONMENT, **{"place": "circuit1", "normalized": False, **settings}).unwrapped


@benchmark("env_step_us", "us", at_most=25)
def env_step_us():
    """What `step` of an environment adds to that of the core: 1 car that stands, 108 beams."""
    environment = _make(max_time=1e6)
    environment.reset(seed=1)
    stage = environment._stage
    command, driven = np.zeros((1, 1, 2)), np.ones((1, 1), dtype=bool)
    whole = _each_us(lambda: environment.step(STANDSTILL))
    core = _each_us(lambda: stage._environments.step(command, driven))
    return Measured(whole - core, {"step_us": whole, "core_us": core})


@benchmark("env_reset_ms", "ms", at_most=1)
def env_reset_ms():
    """Reset of an environment with random starts and drawn parameters, 1 car, 1080 beams."""
    environment = _make(beams=1080, start="random", vehicle={"mu": (0.8, 1.1)})
    environment.reset(seed=1)
    return Measured(_each_us(environment.reset, 50) / 1e3)


@benchmark("env_vector", "x", at_least=1.8, is_ratio=True)
def env_vector():
    """Steps/s of 64 environments that do f1tenth_gym's work, by two threads over those by one, wall time."""
    rates = _rates_by_threads(ENVIRONMENTS, VECTOR_STEPS, beams=1080)
    return Measured(rates[str(THREADS)] / rates["1"], {"steps_per_second": rates})


@benchmark("env_many", "steps/s", at_least=60_000)
def env_many():
    """Steps/s of f1tenth_gym_jax's work: 1024 environments, 64 beams, 10 m, 10 ms, two threads, wall time."""
    rates = _rates_by_threads(MANY, MANY_STEPS, beams=64, range_max=10.0)
    return Measured(rates[str(THREADS)], {"steps_per_second": rates})


@benchmark("env_steps", "steps/s", at_least=10_000)
def env_steps():
    """Steps/s of an environment as f1tenth_gym's: Spielberg, 10 ms, a scan each step; 1 car, 1080 beams."""
    rates = {f"{beams} beams, {cars} cars": _rate(beams, cars) for beams in BEAMS for cars in CARS}
    return Measured(rates["1080 beams, 1 cars"], rates)


def _each_us(work, count=STEPS):
    def all_of_them():
        for _ in range(count):
            work()

    return processor_seconds(all_of_them, REPEATS) / count * 1e6


def _rates_by_threads(count, steps, **settings):
    """Steps/s, by the number of threads as text."""
    if len(os.sched_getaffinity(0)) < THREADS:
        raise NotAvailable(f"{THREADS} threads need as many processors")
    drives = {threads: _vector_drive(threads, count, steps, settings) for threads in (1, THREADS)}
    # In turns, so that what else the machine does falls on both.
    turns = [[timeit.timeit(drive, number=1) for drive in drives.values()] for _ in range(REPEATS)]
    spent = dict(zip(drives, map(min, zip(*turns))))
    return {str(threads): count * steps / seconds for threads, seconds in spent.items()}


def _vector_drive(threads, count, steps, settings):
    settings = {**_f1tenth_gym(), "normalized": False, **settings}
    environments = _gymnasium().make_vec(
        ENVIRONMENT, count, "vector_entry_point", threads=threads, **settings
    )
    environments.reset(seed=1)
    actions = np.tile(np.array([0.0, 1.0], np.float32), (count, 1))

    def drive():
        for _ in range(steps):
            environments.step(actions)

    return drive


def _f1tenth_gym():
    """Settings for the work of f1tenth_gym."""
    return {
        "place": data_file("tracks/Spielberg/Spielberg_map.yaml"),
        "field_of_view": 4.7,
        "range_max": 30.0,
        "period": 0.01,
        "observation": ("scan",),
        "start": "random",
    }


def _rate(beams, cars):
    environment = _make(**_f1tenth_gym(), cars=cars, beams=beams)
    environment.reset(seed=1)
    action = np.zeros(environment.action_space.shape, np.float32)
    action[..., 1] = 1.0  # m/s

    def drive():
        environment.reset(seed=1)
        for _ in range(100):
            environment.step(action)

    return 100 / processor_seconds(drive, 5)
