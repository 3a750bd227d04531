"""A lap that no car could drive so quickly is a fault of the set-up; one that beats the reference is told."""

import dataclasses
import math

import numpy as np
import pytest
from f1tenth_judge.judge.quickest_lap import greatest_acceleration, impossible_laps, shortest_way
from f1tenth_judge.places.place import gates_after, line_across
from f1tenth_judge.plan.task import Task
from f1tenth_judge.record.observations import Observations
from f1tenth_judge.record.record import Record
from f1tenth_judge.run.outcome import judged
from f1tenth_judge.scenario.car import Car, Pose, VehicleModel
from f1tenth_judge.scenario.scenario import StartLine, Verdict
from f1tenth_sim2d.environments.car import Lidar, load_cars
from scenario_samples import PERIOD, record, rows, sample_plan, scenario
from test_road import RADIUS, ring

import f1tenth_sim2d

MIDDLE = math.tau * RADIUS  # m, a lap in the middle of the road


def plan_of(folder, laps=1, task=None, **car):
    """A run on the round road, of a car with these keys."""
    course = ring()
    line = line_across(course, Pose(0.0, -RADIUS, 0.0))
    wanted = dataclasses.replace(scenario(timeout=60.0), cars=(Car("robot1", goals="circuit1", **car),))
    made = sample_plan(folder, wanted)
    lapping = task or Task(laps=laps, line=line, gates=gates_after(course, line))
    return dataclasses.replace(made, cars={"robot1": dataclasses.replace(made.cars["robot1"], task=lapping)})


def around(folder, speed, laps=1.1):
    """A car that goes round and round from the line on, in the middle of the road."""
    turn = speed * PERIOD / RADIUS
    table = []
    for number, row in enumerate(rows(PERIOD * int(laps * math.tau / turn), speed=speed)):
        angle = 0.01 + number * turn
        table.append(
            [
                *row[:2],
                RADIUS * math.sin(angle),
                -RADIUS * math.cos(angle),
                angle,
                speed,
                0,
                turn / PERIOD,
                *row[8:],
            ]
        )
    return record(folder, table)


def test_shortest_way_leads_along_the_inner_edge():
    gates = [StartLine(math.cos(a), math.sin(a), a + math.pi / 2, 1.0) for a in (0.0, math.pi / 2, math.pi)]
    assert shortest_way(gates) == pytest.approx(2 * math.hypot(0.5, 0.5) + 1.0)


def test_lap_is_judged_by_the_way_through_all_gates_once(tmp_path):
    """At a speed at which no tyre matters; a hundredth of the way is left out."""
    plan, track = plan_of(tmp_path), around(tmp_path, 1.0)
    task = plan.tasks["robot1"]
    way = shortest_way([task.line, *task.gates])
    (text,) = impossible_laps(plan, track, {"robot1": [0.9 * way / 1.5]})
    assert f"the shortest way through the road is {0.99 * way:.1f} m, and " in text
    assert float(text.split(" m, and ")[1].split(" s ")[0]) == pytest.approx(0.99 * way / 1.5, rel=0.01)


def test_shortest_way_is_shorter_than_any_lap_and_no_short_cut():
    course = ring()
    line = line_across(course, Pose(0.0, -RADIUS, 0.0))
    assert 0.7 * MIDDLE < shortest_way([line, *gates_after(course, line)]) < 0.9 * MIDDLE


def test_lap_at_the_greatest_speed_of_the_car_is_possible(tmp_path):
    done = judged(plan_of(tmp_path), Observations(around(tmp_path, 20.0)), 1.0, {})
    assert done.judgement.decision.verdict is Verdict.SUCCESS
    assert done.best_lap_time == pytest.approx(MIDDLE / 20.0, rel=0.01)


def test_lap_beyond_it_is_an_error_of_the_set_up(tmp_path):
    done = judged(plan_of(tmp_path), Observations(around(tmp_path, 30.0)), 1.0, {})
    decision = done.judgement.decision
    assert decision.verdict is Verdict.ERROR
    assert decision.reason.startswith("runner: lap 1 of robot1 took 2.0")
    assert "but the shortest way through the road is" in decision.reason
    assert done.judgement.failure.culprit == "runner"
    assert not done.passed


@pytest.mark.parametrize(
    ("car", "is_possible"),
    [
        ({}, True),  # 40 m/s^2, of tyres that are not limited by friction
        ({"mu": 0.4}, False),
        ({"model": VehicleModel.KINEMATIC}, True),
        ({"model": VehicleModel.SINGLE_TRACK_DRIFT}, False),
        ({"model": VehicleModel.SINGLE_TRACK_DRIFT, "mu": 3.0}, True),
    ],
)
def test_lap_is_no_quicker_than_the_car_can_turn(tmp_path, car, is_possible):
    track = around(tmp_path, 20.0)
    found = [*impossible_laps(plan_of(tmp_path, **car), track, {"robot1": [3.1]})]
    assert [text.startswith("lap 1 of robot1 took 3.100 s") for text in found] == [True] * (not is_possible)


@pytest.mark.parametrize("model", [each.value for each in VehicleModel])
@pytest.mark.parametrize("seed", range(3))
def test_no_car_exceeds_the_acceleration_that_laps_are_judged_by(model, seed):
    vehicle, random = f1tenth_sim2d.VehicleParameters(), np.random.default_rng(seed)
    vehicle.model = model
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.empty_world())
    simulation.add_car(load_cars(["robot1"], Lidar(8, 4.7, 10.0))[0], vehicle)
    velocities = []
    for period in range(800):
        if period % 20 == 0:
            command = random.uniform(-3.0, 20.0), random.choice([-0.4, -0.1, 0.0, 0.1, 0.4])
        simulation.command(0, *command)
        simulation.advance_to((period + 1) * PERIOD)
        state = simulation.state(0)
        aside = state.v_y + vehicle.l_r * state.yaw_rate  # of the centre of mass
        velocities.append(complex(state.v_x, aside) * np.exp(1j * state.yaw))
    found = np.abs(np.diff(velocities)) / PERIOD
    assert 5.0 < found.max() < greatest_acceleration(vehicle)


def test_car_that_touches_something_may_turn_quicker_than_by_itself(tmp_path):
    track = around(tmp_path, 20.0).tracks["robot1"]
    touching = dataclasses.replace(track, contacts=("wall", *track.contacts[1:]))
    plan = plan_of(tmp_path, model=VehicleModel.SINGLE_TRACK_DRIFT)
    assert [*impossible_laps(plan, Record({"robot1": touching}), {"robot1": [3.1]})] == []


def test_each_lap_is_looked_at_and_the_first_may_begin_beyond_the_line(tmp_path):
    plan, track = plan_of(tmp_path, laps=2), around(tmp_path, 10.0, laps=2.1)
    assert [*impossible_laps(plan, track, {"robot1": [6.0, 6.0]})] == []
    (second,) = impossible_laps(plan, track, {"robot1": [6.0, 3.0]})
    assert second.startswith("lap 2 of robot1 took 3.000 s")
    half_way = around(tmp_path, 10.0).tracks["robot1"]
    ahead = dataclasses.replace(half_way, x=half_way.x * 0.0, y=half_way.y * 0.0 + RADIUS)
    assert len([*impossible_laps(plan, track, {"robot1": [3.2]})]) == 1
    assert [*impossible_laps(plan, Record({"robot1": ahead}), {"robot1": [3.2]})] == []


def test_where_no_road_is_known_nothing_is_said_of_laps(tmp_path):
    plan = plan_of(tmp_path, task=Task(laps=1, line=StartLine()))
    assert [*impossible_laps(plan, around(tmp_path, 10.0), {"robot1": [0.1]})] == []
    assert [*impossible_laps(plan_of(tmp_path), around(tmp_path, 10.0), {"robot1": []})] == []


@pytest.mark.parametrize(("speed", "is_told"), [(10.0, False), (16.0, True)])
def test_lap_that_beats_the_reference_is_told(tmp_path, speed, is_told):
    plan = plan_of(tmp_path)
    racing = dataclasses.replace(plan.scenario, cars=(Car("robot1", laps=1),))
    done = judged(dataclasses.replace(plan, scenario=racing), Observations(around(tmp_path, speed)), 1.0, {})
    assert done.judgement.decision.verdict is Verdict.SUCCESS
    told = "s, is quicker than the reference of 4.497 s, whose tyres are those of friction alone"
    assert (told in done.note) == is_told
