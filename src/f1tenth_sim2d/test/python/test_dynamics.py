"""The car against CommonRoad's own code (commonroad-vehicle-models), with the parameters of the F1/10 car."""

import math
import sys
from pathlib import Path

import pytest

import f1tenth_sim2d

sys.path.insert(0, str(Path(__file__).parents[1] / "core" / "data"))

from make_single_track_reference import runge_kutta  # noqa: E402

STEP = 0.001  # s
SECONDS = 5.0
REAR_AXLE = 0.17145  # m, from base_footprint to the centre of mass


def step_steer(time):
    return 4.0, (0.0 if time < 1.0 else 0.15)


def slalom(time):
    return 4.0, 0.12 * math.sin(2.0 * math.pi * time / 1.2)


def brake_in_turn(time):
    return (4.0 if time < 2.0 else 0.5), 0.1


def lift_off(time):
    return (5.0 if time < 2.0 else 2.5), 0.08


def from_rest(time):
    return 0.6 * time, 0.3


class Drive:
    """What the simulator makes of a manoeuvre: its inputs and its states at the centre of mass, each step."""

    def __init__(self, car, manoeuvre):
        simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.empty_world(), STEP)
        simulation.add_car(car, f1tenth_sim2d.VehicleParameters())
        self.states = [self._state(simulation)]
        for i in range(round(SECONDS / STEP)):
            simulation.command(0, *manoeuvre(i * STEP))
            simulation.step()
            self.states.append(self._state(simulation))

    @staticmethod
    def _state(simulation):
        """[x, y, steering angle, speed, yaw, yaw rate, slip angle] as CommonRoad orders them."""
        state = simulation.state(0)
        v_y = state.v_y + REAR_AXLE * state.yaw_rate
        x = state.x + REAR_AXLE * math.cos(state.yaw)
        y = state.y + REAR_AXLE * math.sin(state.yaw)
        speed = math.hypot(state.v_x, v_y)
        return [x, y, state.steering_angle, speed, state.yaw, state.yaw_rate, math.atan2(v_y, state.v_x)]

    def inputs(self, i):
        """(steering rate, acceleration) of step i."""
        before, after = self.states[i], self.states[i + 1]
        return (after[2] - before[2]) / STEP, (after[3] - before[3]) / STEP


@pytest.fixture(scope="module")
def car():
    path = Path(__file__).parents[1] / "loaders" / "data" / "small_car.urdf"
    return f1tenth_sim2d.load_car(path.read_text(), "robot1", str(path))


@pytest.mark.parametrize("manoeuvre", [step_steer, slalom, brake_in_turn, lift_off])
def test_car_follows_the_reference_for_five_seconds(car, manoeuvre):
    drive = Drive(car, manoeuvre)
    begin = next(i for i, state in enumerate(drive.states) if state[3] > 0.2)
    reference = list(drive.states[begin])
    for i in range(begin, len(drive.states) - 1):
        reference = runge_kutta(reference, drive.inputs(i), STEP)
        state = drive.states[i + 1]
        assert math.hypot(state[0] - reference[0], state[1] - reference[1]) < 0.01, i
        assert abs(math.remainder(state[4] - reference[4], 2.0 * math.pi)) < math.radians(0.2), i
    assert drive.states[-1][3] > 0.4
    assert max(abs(state[5]) for state in drive.states) > 0.3, "it turned"


def test_yaw_rate_has_no_jump_where_the_model_changes(car):
    rates = [state[5] for state in Drive(car, from_rest).states]
    assert max(rates) > 1.0
    assert max(abs(b - a) for a, b in zip(rates, rates[1:])) < 0.01


def test_steering_and_acceleration_keep_their_limits(car):
    drive = Drive(
        car, lambda time: (20.0 if time < 2.0 else 0.0, 0.4 if time % 0.8 < 0.4 and time > 4.5 else 0.0)
    )
    steering_rates, accelerations = zip(*(drive.inputs(i) for i in range(len(drive.states) - 1)))
    assert max(map(abs, steering_rates)) == pytest.approx(3.2, rel=1e-6)
    assert max(map(abs, accelerations)) == pytest.approx(9.51, rel=1e-3)
    assert max(state[2] for state in drive.states) <= 0.4189
