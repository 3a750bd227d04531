"""The race track on which the peers were measured."""

import math

import f1tenth_sim2d
from f1tenth_bench.places import data_file
from f1tenth_bench.simulator.cars import SPIELBERG, f1tenth_car

DISTANCE = 1.2
"""m, from one car to the next."""


def spielberg(car_count):
    """Return a Simulation of cars in a row behind the start of Spielberg."""
    world = f1tenth_sim2d.load_world(str(data_file("tracks/Spielberg/Spielberg_map.yaml")))
    simulation = f1tenth_sim2d.Simulation(world, seed=1)
    x, y, yaw = world.start
    for i in range(car_count):
        place = (x - i * DISTANCE * math.cos(yaw), y - i * DISTANCE * math.sin(yaw), yaw)
        simulation.add_car(f1tenth_car(SPIELBERG, f"robot{i + 1}"), None, *place)
    return simulation
