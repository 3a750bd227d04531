#!/usr/bin/env python3
"""Writes single_track_reference.csv: manoeuvres driven by CommonRoad's own single-track model.

Needs the PyPI package commonroad-vehicle-models. The model is integrated with Runge-Kutta steps of 0.1 ms;
the inputs of a row hold until the next row.
"""

import csv
import math
import pathlib
import types

from vehiclemodels.vehicle_dynamics_st import vehicle_dynamics_st

ROW_INTERVAL = 0.05
DURATION = 5.0
STEPS_PER_ROW = 500
COLUMNS = [
    "manoeuvre",
    "time",
    "steering_rate",
    "acceleration",
    "x",
    "y",
    "delta",
    "v",
    "psi",
    "psi_dot",
    "beta",
]


class TireOfTwoAxles:
    """Lets the model see the two cornering stiffnesses of the F1/10 car, though it has one for both axles.

    The model works out C_Sf first and C_Sr second, both as -p_ky1 / p_dy1.
    """

    p_dy1 = 1.0489
    stiffness = (4.718, 5.4562)

    def __init__(self):
        self._reads = 0

    @property
    def p_ky1(self):
        """The front axle's value at every odd reading, the rear axle's at every even one."""
        value = -self.stiffness[self._reads % 2] * self.p_dy1
        self._reads += 1
        return value


CAR = types.SimpleNamespace(
    a=0.15875,
    b=0.17145,
    h_s=0.074,
    m=3.74,
    I_z=0.04712,
    tire=TireOfTwoAxles(),
    steering=types.SimpleNamespace(min=-0.4189, max=0.4189, v_min=-3.2, v_max=3.2),
    longitudinal=types.SimpleNamespace(v_min=-5.0, v_max=20.0, v_switch=7.319, a_max=9.51),
)


def step_steer(t):
    """Turn the wheels to 0.16 rad at once and hold."""
    return (3.2 if t < 0.049 else 0.0), 0.0


def slalom(t):
    """Steer to and fro with a period of 1.2 s."""
    return 0.6 * math.cos(2.0 * math.pi * (t + 0.5 * ROW_INTERVAL) / 1.2), 0.0


def brake_in_turn(t):
    """Brake to a crawl below the speed at which the model turns kinematic."""
    return (0.8 if t < 0.099 else 0.0), (-4.0 if 1.0 <= t + 1e-9 < 2.2 else 0.0)


def lift_off(t):
    """Accelerate through a bend, then release."""
    return (1.0 if t < 0.099 else 0.0), (2.0 if t + 1e-9 < 2.0 else -1.5)


def pull_away(t):
    """Start from rest with the wheels turning."""
    return (0.5 if t < 0.399 else 0.0), (1.0 if t + 1e-9 < 2.5 else 0.0)


MANOEUVRES = {step_steer: 3.0, slalom: 4.0, brake_in_turn: 4.85, lift_off: 2.0, pull_away: 0.0}


def runge_kutta(state, inputs, dt):
    """One classical step."""

    def moved(slope, share):
        return [s + share * dt * k for s, k in zip(state, slope, strict=True)]

    k1 = vehicle_dynamics_st(state, inputs, CAR)
    k2 = vehicle_dynamics_st(moved(k1, 0.5), inputs, CAR)
    k3 = vehicle_dynamics_st(moved(k2, 0.5), inputs, CAR)
    k4 = vehicle_dynamics_st(moved(k3, 1.0), inputs, CAR)
    slopes = zip(state, k1, k2, k3, k4, strict=True)
    return [s + dt / 6.0 * (a + 2.0 * b + 2.0 * c + d) for s, a, b, c, d in slopes]


def rows():
    """All rows of the file."""
    for manoeuvre, speed in MANOEUVRES.items():
        state = [0.0, 0.0, 0.0, speed, 0.0, 0.0, 0.0]
        for row in range(round(DURATION / ROW_INTERVAL) + 1):
            time = row * ROW_INTERVAL
            inputs = manoeuvre(time)
            yield [manoeuvre.__name__, f"{time:.2f}", *(f"{value:.12g}" for value in (*inputs, *state))]
            for _ in range(STEPS_PER_ROW):
                state = runge_kutta(state, inputs, ROW_INTERVAL / STEPS_PER_ROW)


def main():
    """Write the file beside this script."""
    target = pathlib.Path(__file__).with_name("single_track_reference.csv")
    with target.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(rows())


if __name__ == "__main__":
    main()
