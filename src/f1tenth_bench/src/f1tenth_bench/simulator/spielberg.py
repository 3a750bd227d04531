"""The race track on which the peers were measured."""

import functools
import math

import f1tenth_sim2d
from f1tenth_bench.places import data_file
from f1tenth_bench.simulator.cars import SPIELBERG, simulation_of
from f1tenth_bench.simulator.laps import PERIOD, record

DISTANCE = 1.2
"""m, from one car to the next."""


def spielberg(car_count):
    """Return a Simulation of cars in a row behind the start of Spielberg."""
    world = _world()
    x, y, yaw = world.start
    behind = [i * DISTANCE for i in range(car_count)]
    places = [(x - m * math.cos(yaw), y - m * math.sin(yaw), yaw) for m in behind]
    return simulation_of(world, places, SPIELBERG)


def places_on_spielberg(count, seconds):
    """Return `count` poses (x, y, yaw), m and rad, that one car passes from the start on, `seconds` apart."""
    driven = record(spielberg(1), count * seconds).poses[:, 0]
    return driven[:: round(seconds / PERIOD)]


def spread_on_spielberg(places):
    """Return a Simulation of a car at each of these poses."""
    return simulation_of(_world(), places, SPIELBERG)


@functools.lru_cache(maxsize=1)
def _world():
    return f1tenth_sim2d.load_world(str(data_file("tracks/Spielberg/Spielberg_map.yaml")))
