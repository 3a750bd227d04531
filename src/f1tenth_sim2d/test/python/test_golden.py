"""Laps whose every bit is known: the same on every machine, with every C library, and after a reset.

If the dynamics change on purpose, put what the failing test prints into data/golden_hashes.json.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from gap_follower import GapFollower

import f1tenth_sim2d

GOLDEN = json.loads((Path(__file__).parent / "data" / "golden_hashes.json").read_text())
PACKAGE = Path(__file__).parents[2]
WORLDS = PACKAGE.parent / "f1tenth_gazebo" / "worlds"
CAR = PACKAGE / "test" / "loaders" / "data" / "small_car.urdf"
SECONDS = 15.0
PERIOD = 0.025  # s
GRAIN = 256.0  # commands are whole multiples of 1 / GRAIN, so that roundings of numpy do not reach the car


class RoundedDriver:
    """A gap follower with rounded commands."""

    def __init__(self, simulation):
        self._simulation = simulation
        self._driver = GapFollower(simulation.car(0).lidars[0])

    def command(self):
        speed, steering = self._driver.command(self._simulation.scan(0))
        return round(speed * GRAIN) / GRAIN, round(steering * GRAIN) / GRAIN


def drive(simulation):
    """Drive for SECONDS; return the trajectory hash."""
    driver = RoundedDriver(simulation)
    for period in range(1, round(SECONDS / PERIOD) + 1):
        simulation.command(0, *driver.command())
        simulation.advance_to(period * PERIOD)
    return simulation.trajectory_hash()


def circuit(name):
    """A simulation of a car on a circuit that the workspace ships."""
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.load_world(str(WORLDS / f"{name}.world")), seed=5)
    car = f1tenth_sim2d.load_car(CAR.read_text(), "robot1", str(CAR))
    simulation.add_car(car, f1tenth_sim2d.VehicleParameters())
    return simulation


@pytest.mark.parametrize("name", sorted(GOLDEN))
def test_trajectory_is_the_golden_one(name):
    simulation = circuit(name)
    fresh = drive(simulation)
    assert fresh == GOLDEN[name], f"{name} gives {fresh}"
    simulation.reset()
    assert drive(simulation) == fresh


@pytest.fixture
def busy_cores():
    """Keep every core busy with other work."""
    loads = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(os.cpu_count())]
    yield
    for load in loads:
        load.kill()
        load.wait()


@pytest.mark.usefixtures("busy_cores")
def test_runs_on_a_busy_machine_are_the_golden_one():
    assert {drive(circuit("circuit1")) for _ in range(4)} == {GOLDEN["circuit1"]}


def test_every_circuit_has_a_golden_trajectory():
    assert sorted(GOLDEN) == sorted(path.stem for path in WORLDS.glob("circuit*.world"))


def test_trajectory_does_not_depend_on_the_c_library_s_choice_of_functions():
    """Without AVX2 and FMA the C library takes other sines and arc tangents."""
    text = f"import sys; sys.path.insert(0, {str(Path(__file__).parent)!r}); import test_golden as t; "
    plain = {**os.environ, "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F,-AVX2_Usable,-FMA_Usable"}
    command = [sys.executable, "-c", text + "print(t.drive(t.circuit('circuit1')))"]
    found = subprocess.run(command, env=plain, capture_output=True, text=True, check=True).stdout.strip()
    assert found == GOLDEN["circuit1"]
