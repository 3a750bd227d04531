#!/usr/bin/env python3
"""Writes single_track_drift_reference.csv: manoeuvres driven by CommonRoad's own single-track drift model.

Needs the PyPI package commonroad-vehicle-models. Three of its cars (Ford Escort, BMW 320i, VW Vanagon) drive
each manoeuvre. The model is integrated with Runge-Kutta steps of 0.25 ms; the inputs of a row hold until the
next row.
"""

import csv
import math
import pathlib

from vehiclemodels.init_std import init_std
from vehiclemodels.parameters_vehicle1 import parameters_vehicle1
from vehiclemodels.parameters_vehicle2 import parameters_vehicle2
from vehiclemodels.parameters_vehicle3 import parameters_vehicle3
from vehiclemodels.vehicle_dynamics_std import vehicle_dynamics_std

ROW_INTERVAL = 0.05
DURATION = 5.0
STEPS_PER_ROW = 200
KEPT_ROWS = 5  # of which one is written, besides those in which an input changes
COLUMNS = ["car", "manoeuvre", "time", "steering_rate", "acceleration"]
COLUMNS += ["x", "y", "delta", "v", "psi", "psi_dot", "beta", "omega_f", "omega_r"]
CARS = {"escort": parameters_vehicle1(), "bmw": parameters_vehicle2(), "vanagon": parameters_vehicle3()}


def step_steer(t):
    """Turn the wheels to 0.14 rad within 0.35 s and hold: more than the tyres can give."""
    return (0.4 if t < 0.349 else 0.0), 0.0


def slalom(t):
    """Steer to and fro, faster than the car likes."""
    return (0.25 if (t + 1e-9) % 1.6 < 0.4 or (t + 1e-9) % 1.6 >= 1.2 else -0.25), 0.0


def brake_then_turn(t):
    """Brake until all wheels stand, let go, and turn."""
    return (0.2 if 1.2 <= t + 1e-9 < 1.499 else 0.0), (-9.0 if 0.2 <= t + 1e-9 < 1.0 else 0.0)


def power_slide(t):
    """Accelerate hard in a tight bend; the wheels of a car with front drive spin."""
    return (0.4 if t < 0.599 else 0.0), (5.5 if 0.6 <= t + 1e-9 < 2.5 else 0.5)


MANOEUVRES = {step_steer: 20.0, slalom: 14.0, brake_then_turn: 20.0, power_slide: 6.0}


def runge_kutta(state, inputs, car, dt):
    """One classical step."""

    def slope(moved):
        return vehicle_dynamics_std(list(moved), inputs, car)

    def moved(along, share):
        return [s + share * dt * k for s, k in zip(state, along, strict=True)]

    k1 = slope(state)
    k2 = slope(moved(k1, 0.5))
    k3 = slope(moved(k2, 0.5))
    k4 = slope(moved(k3, 1.0))
    slopes = zip(state, k1, k2, k3, k4, strict=True)
    stepped = [s + dt / 6.0 * (a + 2.0 * b + 2.0 * c + d) for s, a, b, c, d in slopes]
    stepped[7:] = [max(0.0, omega) for omega in stepped[7:]]
    return stepped


def rows(name, car, manoeuvre, speed):
    """All rows of one manoeuvre of one car."""
    state = init_std([0.0, 0.0, 0.0, speed, 0.0, 0.0, 0.0], car)
    last_inputs = None
    for row in range(round(DURATION / ROW_INTERVAL) + 1):
        time = row * ROW_INTERVAL
        inputs = manoeuvre(time)
        if row % KEPT_ROWS == 0 or inputs != last_inputs:
            values = (f"{value:.12g}" for value in (*inputs, *state))
            yield [name, manoeuvre.__name__, f"{time:.2f}", *values]
        last_inputs = inputs
        for _ in range(STEPS_PER_ROW):
            state = runge_kutta(state, inputs, car, ROW_INTERVAL / STEPS_PER_ROW)
    assert all(math.isfinite(value) for value in state)


def main():
    """Write the file beside this script."""
    target = pathlib.Path(__file__).with_name("single_track_drift_reference.csv")
    with target.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for name, car in CARS.items():
            for manoeuvre, speed in MANOEUVRES.items():
                writer.writerows(rows(name, car, manoeuvre, speed))


if __name__ == "__main__":
    main()
