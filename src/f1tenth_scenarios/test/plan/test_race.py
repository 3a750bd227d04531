"""A race that is in no scenario file: its planners, its results folder, the file of --save."""

import math
import shutil

import pytest
import yaml
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.scenario.driver import Driver

from f1tenth_judge import cli


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The working directory: a planner with an argument, one without, and a file to name."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "with.launch").write_text('<launch><arg name="line" default=""/></launch>', encoding="utf-8")
    (tmp_path / "without.launch").write_text("<launch/>", encoding="utf-8")
    (tmp_path / "c.csv").touch()
    return tmp_path


def saved(folder, *arguments, name="race.yaml"):
    """What `race --save` writes."""
    assert cli.main(["race", *arguments, "--save", str(folder / name)]) == 0
    return yaml.safe_load((folder / name).read_text(encoding="utf-8"))


def drivers(scenario):
    return [car["driver"] for car in scenario["cars"]]


@pytest.mark.parametrize("command", ["race", "run"])
def test_planner_that_is_not_there_is_answered_with_what_is_allowed(folder, capsys, command):
    assert cli.main([command, "circuit1", "--planner", "nonsense"]) == 2
    allowed = (
        "a launch file, package://PACKAGE/PATH, FILE.py:CLASS, POLICY.onnx, POLICY.zip of stable-baselines3,"
        " or one of ours: race, pursuit, gap_follower"
    )
    wanted = f"f1tenth: --planner nonsense: no such file: {folder}/nonsense; allowed: {allowed}\n"
    assert capsys.readouterr().err == wanted


class TestArguments:
    def test_are_given_to_the_planners_that_have_them(self, folder):
        planners = ["--planner", "with.launch", "--planner", "without.launch", "--planner", "gap_follower"]
        found = drivers(saved(folder, "circuit1", *planners, "--arg", "line:=1"))
        assert [each.get("arguments") for each in found[:2]] == [{"line": "1"}, None]
        assert found[2] == "gap_follower"

    def test_that_no_planner_has_are_answered(self, folder, capsys):
        planners = ["--planner", "with.launch", "--planner", "without.launch"]
        assert cli.main(["race", "circuit1", *planners, "--arg", "speed:=1"]) == 2
        wanted = f"f1tenth: robot1: {folder}/with.launch has no argument 'speed'; it has: line\n"
        assert capsys.readouterr().err == wanted


class TestName:
    def test_is_that_of_the_place_unless_it_is_given(self):
        assert Race("circuit1", 1, []).name == "race_circuit1"
        assert Race("circuit1", 1, [], called="mine_2.0").name == "mine_2.0"

    @pytest.mark.parametrize("name", ["", "../mine", ".mine", "a b"])
    def test_that_is_no_name_of_a_folder_is_refused(self, folder, capsys, name):
        assert cli.main(["race", "circuit1", "--name", name]) == 2
        wanted = "must begin with a letter or a digit and have only those and '_.=,+-'"
        assert capsys.readouterr().err == f"f1tenth: --name {name}: {wanted}\n"


class TestRepeat:
    def test_runs_it_again_and_again(self, folder, program, capsys):
        options = ["--repeat", "2", "--set", "seed=3", "--results", "r"]
        assert cli.main(["race", "circuit1", "--planner", "with.launch", *options]) == 0
        assert program.runs() == ["001", "002"]
        assert (folder / "r" / "repeat" / "race_circuit1" / "002" / "race_circuit1" / "result.json").exists()
        assert "trajectories:      all the same, bit for bit" in capsys.readouterr().out
        plan = make_plan(str(folder / "r" / "races" / "race_circuit1.yaml"))
        assert plan.cars["robot1"].driver.path == folder / "with.launch"

    @pytest.mark.parametrize(
        ("options", "answer"),
        [
            (["--repeat", "1"], "--repeat is for one scenario, and at least 2 times"),
            (["--repeat", "2", "--attach"], "--attach is not for --repeat"),
            (["--repeat", "2", "--save", "a.yaml"], "--save is not for --repeat"),
        ],
    )
    def test_with_options_that_change_nothing_is_refused(self, folder, capsys, options, answer):
        assert cli.main(["race", "circuit1", *options]) == 2
        assert capsys.readouterr().err == f"f1tenth: {answer}\n"


class TestSave:
    def test_names_what_is_in_a_package_by_that(self, folder):
        file = lookup.package_path("f1tenth_scenarios") / "launch" / "drivers" / "pure_pursuit.launch"
        (driver,) = drivers(saved(folder, "circuit1", "--planner", str(file), "--arg", "speed_max:=2"))
        assert driver["launch"] == "package://f1tenth_scenarios/launch/drivers/pure_pursuit.launch"

    def test_names_what_is_in_none_from_where_the_file_is(self, folder):
        (folder / "scenarios").mkdir()
        name = "scenarios/race.yaml"
        options = ["--planner", "with.launch", "--arg", "line:=c.csv"]
        (driver,) = drivers(saved(folder, "circuit1", *options, name=name))
        assert (driver["launch"], driver["arguments"]) == ("../with.launch", {"line": "../c.csv"})
        plan = make_plan(str(folder / name))
        assert plan.cars["robot1"].driver.path == folder / "with.launch"

    def test_names_a_class_from_where_the_file_is(self, folder):
        (folder / "mine.py").touch()
        assert drivers(saved(folder, "circuit1", "--planner", "mine.py:Mine")) == [{"python": "mine.py:Mine"}]
        plan = make_plan(str(folder / "race.yaml"))
        assert plan.cars["robot1"].driver.path == folder / "mine.py"

    def test_names_a_world_that_was_given_by_its_name_by_that(self, folder):
        assert saved(folder, "circuit1")["world"] == "circuit1"
        path = lookup.world_file("circuit1", folder)
        (folder / "circuit1").symlink_to(path.parent)
        by_path = saved(folder, "circuit1/circuit1.world")
        assert by_path["world"].endswith("worlds/circuit1.world")
        assert make_plan(str(folder / "race.yaml")).place.world == path

    def test_names_the_world_from_where_the_file_is(self, folder):
        (folder / "maps").mkdir()
        original = lookup.map_file(lookup.world_file("circuit1", folder))
        shutil.copy(original, folder / "maps" / "lab.yaml")
        shutil.copy(original.with_suffix(".pgm"), folder / "maps")
        line = "0,0,1,1\n1,0,1,1\n0,1,1,1\n"
        (folder / "maps" / "lab_centerline.csv").write_text(line, encoding="utf-8")
        scenario = saved(folder, "maps/lab.yaml", "--planner", "without.launch")
        assert scenario["world"] == "maps/lab.yaml"
        assert make_plan(str(folder / "race.yaml")).place.world == folder / "maps" / "lab.yaml"

    def test_rounds_times_up(self, folder):
        limits = saved(folder, "circuit1", "--laps", "2")["limits"]
        assert f"{limits}" == "{'timeout': 94.2, 'wall': 488.4}"


def starts(place, count, folder):
    """Where cars are put, each a tuple of x, y, yaw."""
    planner = Driver(launch=str(folder / "without.launch"))
    plan = plan_race(Race(str(place), 1, [planner] * count), folder / "results")
    return [(car.start.x, car.start.y, car.start.yaw) for car in plan.cars.values()]


@pytest.mark.parametrize("count", [1, 2, 3])
def test_cars_start_on_the_line_side_by_side_the_first_on_the_left(folder, count):
    found = starts("circuit1", count, folder)
    assert {(x, yaw) for x, _, yaw in found} == {(0.0, 0.0)}
    assert [y for _, y, _ in found] == pytest.approx(
        [0.3 * (count - 1) - 0.6 * number for number in range(count)]
    )


def test_cars_start_beside_each_other_whatever_the_heading(folder):
    world = folder / "turned.world"
    shutil.copy(lookup.world_file("circuit1", folder), world)
    corners = ("0.0, -2.0", "0.0, 2.0", "-4.0, 2.0", "-4.0, -2.0")
    text = "".join(f"{corner}, 1.0, 1.0\n" for corner in corners)
    (folder / "turned_centerline.csv").write_text(text, encoding="utf-8")
    (left_x, left_y, left_yaw), (right_x, right_y, right_yaw) = starts(world, 2, folder)
    assert left_yaw == right_yaw
    ahead = math.cos(left_yaw), math.sin(left_yaw)
    assert (right_x - left_x, right_y - left_y) == pytest.approx((0.6 * ahead[1], -0.6 * ahead[0]), abs=1e-6)
    assert abs(ahead[1]) > 0.5
