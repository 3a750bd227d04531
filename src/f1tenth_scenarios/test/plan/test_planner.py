"""Another planner in the place of ours, where that makes sense."""

import shutil

import pytest
from f1tenth_judge.errors import NotApplicableError, ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.planner import planner_setting
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.results.console import summary
from f1tenth_judge.scenario.driver import Driver, Interface
from fake_run import FakeRun
from scenario_samples import SCENARIO_TEXT, finished, racing


@pytest.fixture
def planned(tmp_path):
    """Plans a shipped scenario with a planner that declares some arguments."""

    def plan(name, *arguments, given=None):
        declared = "".join(f'<arg name="{each}" default=""/>' for each in arguments)
        path = tmp_path / "my.launch"
        path.write_text(f"<launch>{declared}</launch>", encoding="utf-8")
        planner = Driver(str(path), Interface.F1TENTH, given or {})
        return make_plan(name, settings=[planner_setting(planner)])

    return plan


def test_planner_takes_the_place_of_ours(planned):
    plan = planned("circuit3", "speed", given={"speed": "4.0"})
    assert plan.cars["robot1"].driver.path.name == "my.launch"
    driver = plan.scenario.cars[0].driver
    assert (driver.interface, driver.arguments) == (Interface.F1TENTH, {"speed": "4.0"})


def test_other_drivers_stay(planned):
    plan = planned("overtaking")
    assert plan.scenario.cars[1].driver.name == "pursuit"


def test_who_knows_no_goals_is_judged_by_laps(planned):
    task = planned("circuit1_three_laps").tasks["robot1"]
    assert (task.laps, task.goals, task.obeys_start) == (3, (), False)


def test_who_takes_goals_is_judged_by_them(planned):
    plan = planned("circuit1", "goals_file")
    assert len(plan.tasks["robot1"].goals) == 5
    assert planned("goal_ahead", "goals_file").tasks["robot1"].goals


def test_goals_of_a_circuit_are_found_where_its_world_is_named_by_a_path(planned, tmp_path):
    file = tmp_path / "own.yaml"
    world = lookup.world_file("circuit1", tmp_path)
    file.write_text(sample_without_goals(world), encoding="utf-8")
    assert len(planned(str(file), "goals_file").tasks["robot1"].goals) == 5
    assert planned(str(file)).tasks["robot1"].laps == 1


@pytest.mark.parametrize("arguments", [(), ("goals_file",)])
def test_who_drives_where_there_are_no_goals_is_judged_by_laps(planned, tmp_path, arguments):
    file, track = tmp_path / "own.yaml", tmp_path / "track_map.yaml"
    original = lookup.map_file(lookup.world_file("circuit1", tmp_path))
    shutil.copy(original, track)
    shutil.copy(original.with_suffix(".pgm"), tmp_path)
    (tmp_path / "track_centerline.csv").write_text("0,0,1,1\n1,0,1,1\n0,1,1,1\n", encoding="utf-8")
    file.write_text(sample_without_goals(track) + "laps: 2\n", encoding="utf-8")
    task = planned(str(file), *arguments).tasks["robot1"]
    assert (task.laps, task.goals) == (2, ())


def sample_without_goals(world):
    return SCENARIO_TEXT.replace("    goals: circuit1\n", "").replace("world: circuit1", f"world: {world}")


def test_summary_lists_what_a_planner_gets_in_the_place_of_its_own_defaults(planned, tmp_path):
    result = FakeRun(tmp_path).records(4.0).hears(racing(), finished(3.0)).execute()
    declared = ("seed", "line", "map_file", "speed")
    plan = planned("circuit1", *declared, given={"map_file": "mine.yaml"})
    line = "arguments:         of robot1 by the scenario: line=circuit1_centerline.csv, seed=1\n"
    assert line in summary(result, plan)
    assert "arguments" not in summary(result, planned("circuit1", "speed"))
    assert "arguments" not in summary(result, make_plan("circuit1"))  # ours know what they get


def test_settings_of_our_planner_are_not_for_others(planned):
    assert planned("low_friction").scenario.cars[0].acceleration_max is None
    assert planned("low_friction", "acceleration_max").scenario.cars[0].acceleration_max == 2.0


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("planner_killed", "it kills robot1/move_base, a node of another planner"),
        ("into_the_wall", "no planner drives in it, only: commands"),
        ("goal_in_wall", "it expects 'aborted', which says nothing about another planner"),
        ("goal_ahead", "it is about goals, and the planner has no argument 'goals_file'"),
        ("late_start", "it is about the countdown, and the planner has no argument 'time_to_start'"),
    ],
)
def test_scenario_that_says_nothing_about_a_planner_is_not_applicable(planned, name, reason):
    with pytest.raises(NotApplicableError, match=reason):
        planned(name)


def test_planner_without_a_launch_file_is_an_error(tmp_path):
    planner = Driver(str(tmp_path / "none.launch"))
    with pytest.raises(ScenarioError, match="no such file: .*none.launch") as caught:
        make_plan("circuit1", settings=[planner_setting(planner)])
    assert not isinstance(caught.value, NotApplicableError)


def test_setting_is_one_line_whatever_the_arguments_are():
    planner = Driver("/a b/my.launch", arguments={f"argument_{number}": "x" * 30 for number in range(9)})
    assert "\n" not in planner_setting(planner)
