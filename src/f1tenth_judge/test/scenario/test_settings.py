"""Values that are set from outside of the file, and what many of them mean."""

import itertools
import re

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.scenario.settings import (
    Setting,
    folder_name,
    parse_setting,
    parse_variation,
)
from scenario_samples import SCENARIO_TEXT


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "sample.yaml"
    path.write_text(SCENARIO_TEXT, encoding="utf-8")
    return str(path)


def test_value_of_the_file_is_replaced(file):
    plan = make_plan(file, settings=["seed=7", "limits.timeout=20", "criteria.lap_time=9.5", "laps=2"])
    assert (plan.scenario.seed, plan.scenario.limits.timeout) == (7, 20.0)
    assert (plan.scenario.criteria.lap_time, plan.scenario.laps) == (9.5, 2)
    assert plan.settings == ("seed=7", "limits.timeout=20", "criteria.lap_time=9.5", "laps=2")


def test_key_of_a_car_counts_for_all_cars():
    plan = make_plan("head_to_head", settings=["mu=0.5"])
    assert [car.mu for car in plan.scenario.cars] == [0.5, 0.5]


TWO_CARS = "  - {name: robot1, driver: DRIVER, laps: 1}\n  - {name: robot2, driver: pursuit, laps: 1}\n"


@pytest.fixture
def race_of_two(tmp_path):
    """A scenario of a planner with an argument against one of ours."""
    launch = '<launch><arg name="lookahead" default="1"/></launch>'
    (tmp_path / "my.launch").write_text(launch, encoding="utf-8")
    path = tmp_path / "sample.yaml"
    cars = TWO_CARS.replace("DRIVER", "{launch: my.launch}")
    path.write_text(SCENARIO_TEXT.replace("  - name: robot1\n    goals: circuit1\n", cars), encoding="utf-8")
    return path


@pytest.mark.parametrize("key", ["driver.arguments.lookahead", "cars.robot1.driver.arguments.lookahead"])
def test_argument_counts_for_all_cars_with_a_launch_file(race_of_two, key):
    plan = make_plan(str(race_of_two), settings=[f"{key}=1.5"])
    assert [car.driver.arguments for car in plan.scenario.cars] == [{"lookahead": "1.5"}, {}]


def test_argument_where_no_car_has_a_launch_file_is_answered(file):
    where = "is for cars whose driver is a mapping, as in {launch: my.launch}; there is none"
    with pytest.raises(ScenarioError, match=f"^driver.arguments.speed=1: {where}$"):
        make_plan(file, settings=["driver.arguments.speed=1"])


def test_value_of_one_car_is_replaced():
    plan = make_plan("head_to_head", settings=["cars.robot2.mu=0.5"])
    assert [car.mu for car in plan.scenario.cars] == [None, 0.5]


def test_goals_and_line_are_those_of_the_world(tmp_path):
    path = tmp_path / "sample.yaml"
    cars = "  - name: robot1\n  - {name: robot2, driver: pursuit}\n"
    path.write_text(SCENARIO_TEXT.replace("  - name: robot1\n    goals: circuit1\n", cars), encoding="utf-8")
    plan = make_plan(str(path), settings=["world=circuit3"])
    assert plan.goals_file("robot1").name == "circuit3.txt"
    assert plan.cars["robot2"].line.name == "circuit3.yaml"


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("cars.robot3.mu=1", "cars.robot3.mu=1: there is no robot3, there are: robot1$"),
        ("cars.mu=1", "cars.mu=1: must name one of cars, as in cars.robot1"),
        ("seed", "'seed' must be KEY=VALUE, as in mu=0.3"),
        ("seed=x", "seed=x:1: seed must be a whole number, found 'x'"),
        ("mu=9", r"mu=9:1: cars\[0\].mu is 9, must be above 0 and at most 3"),
        (
            "colour=red",
            "^colour=red: unknown key 'colour'; allowed: the keys that `f1tenth keys` lists,"
            " and driver.arguments.NAME for an argument of a planner$",
        ),
        ("seed.x=1", "seed.x=1: seed holds no keys"),
        ("seed=[1", "seed=.1: not YAML: "),
        ("mu= ", "mu= : must hold a value, found nothing$"),
        ("mu=#1", "mu=#1: must hold a value, found nothing$"),
        (f"mu={3000 * '['}", r"\[: lists or mappings are nested too deeply$"),
        (
            "boxes=[{name: a, x: 1, y: b}]",
            r"^boxes=\[.*b}\]:1: boxes\[0\].y must be a number \(m\), found 'b'",
        ),
    ],
)
def test_bad_setting_is_answered(file, text, problem):
    with pytest.raises(ScenarioError, match=problem):
        make_plan(file, settings=[text])


@pytest.mark.parametrize(
    ("cars", "setting", "problem"),
    [
        (
            "[robot1]",
            "mu=0.3",
            r"FILE:3: cars\[0\] must be a mapping with the keys name, start, .*, found 'robot1'",
        ),
        ("[robot1]", "cars.robot1.mu=0.3", "cars.robot1.mu=0.3: there is no robot1, there are: none"),
        ("[{name: [a]}]", "cars.robot1.mu=0.3", "cars.robot1.mu=0.3: there is no robot1, there are: none"),
    ],
)
def test_setting_for_cars_that_are_none_is_answered(tmp_path, cars, setting, problem):
    path = tmp_path / "sample.yaml"
    cars_text = SCENARIO_TEXT[SCENARIO_TEXT.index("cars:") : SCENARIO_TEXT.index("limits:")]
    path.write_text(SCENARIO_TEXT.replace(cars_text, f"cars: {cars}\n"), encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        make_plan(str(path), settings=[setting])
    assert re.match(problem, str(caught.value).replace(str(path), "FILE"))


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("seed=1:3", ["1", "2", "3"]),
        ("mu=0.3:1.0:3", ["0.3", "0.65", "1"]),
        ("world=a,b", ["a", "b"]),
        ("seed=4", ["4"]),
        ("boxes=[],[{name: a, x: 1, y: 2}]", ["[]", "[{name: a, x: 1, y: 2}]"]),
    ],
)
def test_variation_stands_for_values(text, values):
    assert [each.value for each in parse_variation(text)] == values


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("mu=a:b:3", "'mu=a:b:3': must be a number, found 'a'; allowed are FIRST:LAST"),
        ("mu=0.3:inf:3", "'mu=0.3:inf:3': must be a number, found 'inf'"),
        ("mu=0.3:1:x", "'mu=0.3:1:x': the number of values must be a whole number, found 'x'"),
        ("mu=0.3:1:-2", "'mu=0.3:1:-2' stands for 0 values, must be 1 to 100000"),
        ("seed=1:x", "'seed=1:x': must be a whole number, found 'x'"),
        ("seed=1,2,1", "'seed=1,2,1' has the value 1 more than once"),
        ("mu=1:1.0000001:3", "'mu=1:1.0000001:3' has the value 1 more than once"),
        ("seed=1:99999999999999", "'seed=1:99999999999999' stands for 99999999999999 values"),
        ("seed=5:1", "'seed=5:1' stands for 0 values"),
        ("mu=0:1:1000000", "'mu=0:1:1000000' stands for 1000000 values"),
    ],
)
def test_bad_variation_is_answered(text, problem):
    with pytest.raises(ScenarioError, match=problem):
        parse_variation(text)


def test_every_value_meets_every_other():
    pairs = itertools.product(parse_variation("mu=1,2"), parse_variation("seed=1:2"))
    assert [folder_name(pair) for pair in pairs] == [
        "mu=1,seed=1",
        "mu=1,seed=2",
        "mu=2,seed=1",
        "mu=2,seed=2",
    ]


def test_folder_has_a_name_that_every_system_takes():
    assert folder_name([Setting("world", "../a b.world"), parse_setting("x=1")]) == "world=.._a_b.world,x=1"
