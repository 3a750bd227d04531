"""What is to happen when, and when a period may go on."""

import pytest
from f1tenth_judge.plan.participants import has_proxy_driver, participants
from f1tenth_judge.scenario.car import STANDING, Command, command_at
from f1tenth_judge.scenario.scenario import Fault, Localization
from f1tenth_scenarios.run.events.agenda import Agenda, PeriodGate
from scenario_samples import sample_plan, scenario


def test_actions_happen_in_order_of_time_and_once():
    done = []
    agenda = Agenda([(2.0, lambda: done.append("late")), (1.0, lambda: done.append("early"))])
    for now in (0.975, 1.0, 1.025, 2.5, 3.0):
        agenda.act(now)
        done.append(now)
    assert done == [0.975, "early", 1.0, 1.025, "late", 2.5, 3.0]
    assert agenda.empty


def test_action_is_due_from_its_time_on():
    agenda = Agenda([(1.0, lambda: None)])
    assert not agenda.is_due(0.999)
    assert agenda.is_due(1.0)
    assert not Agenda([]).is_due(1.0)


def test_gate_opens_when_all_that_matter_have_answered():
    gate = PeriodGate(["robot1/move_base", "robot2/move_base"])
    gate.answer("robot1/move_base", 1.0)
    gate.answer("race_starter", 1.0)
    assert not gate.is_open(1.0)
    gate.answer("robot2/move_base", 1.025)
    assert gate.is_open(1.0)
    assert not gate.is_open(1.025)


def test_gate_that_nobody_matters_to_is_open():
    assert PeriodGate([]).is_open(1.0)


COMMANDS = (Command(1.0, 2.0), Command(3.0, 0.5, 0.1))


@pytest.mark.parametrize(
    ("now", "command"),
    [
        (0.0, STANDING),
        (0.975, STANDING),
        (1.0, COMMANDS[0]),
        (2.999, COMMANDS[0]),
        (3.0, COMMANDS[1]),
        (9.0, COMMANDS[1]),
    ],
)
def test_command_holds_until_the_next(now, command):
    assert command_at(COMMANDS, now) == command


def test_participants_of_a_race(tmp_path):
    assert participants(sample_plan(tmp_path, scenario(cars=("robot1", "robot2")))) == [
        "robot1/move_base", "robot1/race_mgr", "robot2/move_base", "robot2/race_mgr", "race_starter",
    ]  # fmt: skip


def test_amcl_acts_first(tmp_path):
    wanted = scenario(cars=("robot1", "robot2"), localization=Localization.AMCL)
    assert participants(sample_plan(tmp_path, wanted)) == [
        "robot1/amcl", "robot2/amcl", "robot1/move_base", "robot1/race_mgr", "robot2/move_base",
        "robot2/race_mgr", "race_starter",
    ]  # fmt: skip


def test_driver_that_answers_scans_takes_part_as_its_car(tmp_path):
    assert participants(sample_plan(tmp_path, scenario(), launch="commands.launch")) == ["robot1"]


@pytest.mark.parametrize("named", ["", '<arg name="participants" value=""/>'])
def test_proxy_driver_takes_part_for_a_driver_that_names_nobody(tmp_path, named):
    launch = tmp_path / "my.launch"
    launch.write_text(f"<launch>{named}</launch>", encoding="utf-8")
    plan = sample_plan(tmp_path, scenario(), launch=launch)
    assert participants(plan) == ["robot1/proxy_driver"]
    assert has_proxy_driver(plan, "robot1")


def test_faults_make_the_runner_a_participant(tmp_path):
    wanted = scenario(faults=(Fault("robot1/move_base", 5.0),))
    assert participants(sample_plan(tmp_path, wanted))[-1] == "scenario"


def test_without_lockstep_nobody_takes_part(tmp_path):
    wanted = scenario(lockstep=False, faults=(Fault("robot1/move_base", 5.0),))
    assert participants(sample_plan(tmp_path, wanted)) == []
