"""Blows against a box give no energy and keep momentum."""

import math
from pathlib import Path

import numpy as np
import pytest

import f1tenth_sim2d

STEP = 0.001  # s
MASS, INERTIA, REAR_AXLE = 3.74, 0.04712, 0.17145  # kg, kg m^2, m
BOX_MASS, BOX_SIZE, BOX_INERTIA = 1.5, 0.4, 0.04  # kg, m, kg m^2
GRIP = 1.05 * 9.81  # m/s^2, more than tyres or the ground can give
WORLD = f"""<sdf version='1.6'><world name='w'><model name='box'>
<pose>2.5 OFFSET 0.2 0 0 0.3</pose><link name='l'>
<inertial><mass>{BOX_MASS}</mass><inertia><ixx>{BOX_INERTIA}</ixx><iyy>{BOX_INERTIA}</iyy><izz>{BOX_INERTIA}</izz>
<ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial>
<collision name='c'><geometry><box><size>{BOX_SIZE} {BOX_SIZE} {BOX_SIZE}</size></box></geometry>
<surface><bounce><restitution_coefficient>0.6</restitution_coefficient></bounce></surface></collision>
</link></model></world></sdf>"""


@pytest.fixture(scope="module")
def car_text():
    return (Path(__file__).parents[1] / "loaders" / "data" / "small_car.urdf").read_text()


def car_motion(state):
    """Velocity of the centre of mass in the world, and yaw rate."""
    v_x, v_y = state.v_x, state.v_y + REAR_AXLE * state.yaw_rate
    c, s = math.cos(state.yaw), math.sin(state.yaw)
    return np.array([c * v_x - s * v_y, s * v_x + c * v_y, state.yaw_rate])


def energy(mass, inertia, motion):
    return 0.5 * mass * (motion[0] ** 2 + motion[1] ** 2) + 0.5 * inertia * motion[2] ** 2


def strike(simulation, speed):
    """(energy, momentum) of car and box before their first contact, and of each step soon after it."""
    while simulation.clearance(0) >= 0.03 * speed:
        simulation.command(0, speed, 0.0)
        simulation.step()
    # From here on nobody drives, so that nothing adds energy.
    simulation.command(0, 0.0, 0.0)
    motion = car_motion(simulation.state(0))
    before, after = None, []
    pose = np.array(simulation.model_pose("box"))
    while len(after) < 100:
        if not simulation.contacts(0):
            motion = car_motion(simulation.state(0))
            before = energy(MASS, INERTIA, motion), MASS * motion[:2]
        simulation.step()
        box = (np.array(simulation.model_pose("box")) - pose) / STEP
        pose = np.array(simulation.model_pose("box"))
        motion = car_motion(simulation.state(0))
        if simulation.contacts(0):
            total = energy(MASS, INERTIA, motion) + energy(BOX_MASS, BOX_INERTIA, box)
            after.append((total, MASS * motion[:2] + BOX_MASS * box[:2]))
    # In the first steps the solver also pushes apart what has sunk in: the box's steps are no velocity there.
    return before, after[3:]


@pytest.mark.parametrize("offset", [0.0, 0.15, -0.28])
@pytest.mark.parametrize("speed", [1.0, 4.0])
def test_blow_against_a_box_gains_no_energy_and_keeps_momentum(tmp_path, car_text, offset, speed):
    file = tmp_path / "box.world"
    file.write_text(WORLD.replace("OFFSET", str(offset)))
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.load_world(str(file)), STEP)
    simulation.add_car(f1tenth_sim2d.load_car(car_text, "robot1", "car"), f1tenth_sim2d.VehicleParameters())
    (energy_before, momentum_before), after = strike(simulation, speed)
    energies = [energy_before] + [each[0] for each in after]
    assert max(b - a for a, b in zip(energies, energies[1:])) < 2e-3 * energy_before
    change = np.hypot(*(after[0][1] - momentum_before))
    assert change < 5 * STEP * GRIP * (MASS + BOX_MASS) + 0.01 * np.hypot(*momentum_before)
    assert np.hypot(*(np.array(simulation.model_pose("box"))[:2] - (2.5, offset))) > 0.02, (
        "the box was struck"
    )
