"""Suites: their cases, the places that they make, and the command; most runs are made up."""

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest
from f1tenth_judge.cli.suite_command import all_suites
from f1tenth_judge.places.course import Course, read_course
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.scenario.scenario import Verdict
from f1tenth_judge.suites import encounters, labs, made_places, safety, scorecard, tracks
from PIL import Image

from f1tenth_judge import cli

SUITE_FOLDER = Path(encounters.__file__).parent
SUITES = ("encounters", "labs", "pace", "safety", "tracks")
SQUARE = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)])
CLASSES = Path(__file__).parents[1] / "drivers" / "python" / "classes.py"
FOLLOWER = "package://f1tenth_scenarios/launch/drivers/gap_follower.launch"


@pytest.fixture
def data(tmp_path, monkeypatch):
    """A folder of tracks with one track, a square that leaves 1 m to the right and 2 m to the left."""
    folder = tmp_path / "data" / "tracks" / "Square"
    folder.mkdir(parents=True)
    np.savetxt(
        folder / "Square_centerline.csv", np.column_stack([SQUARE, [1.0] * 4, [2.0] * 4]), delimiter=", "
    )
    (folder / "Square_map.yaml").write_text(
        "image: Square_map.png\nresolution: 0.1\norigin: [-5.0, -5.0, 0.0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.2\n"
    )
    Image.new("L", (140, 140), 255).save(folder / "Square_map.png")
    monkeypatch.setenv("F1TENTH_DATA", str(tmp_path / "data"))
    return folder


def planned(suite, settings, *more):
    file = SUITE_FOLDER / f"{suite.scenario}.yaml"
    return make_plan(str(file), settings=[*map(str, settings), *more])


@pytest.mark.parametrize("name", sorted({*SUITES} - {"labs"}))
@pytest.mark.parametrize("planner", ["", f"planner={{launch: {FOLLOWER}}}"])
def test_the_scenario_of_a_suite_is_one_on_every_circuit_for_any_planner(name, planner):
    plan = planned(all_suites()[name], ["world=circuit5"], *filter(None, [planner]))
    assert plan.scenario.expected is Verdict.SUCCESS
    assert plan.tasks["robot1"].laps == 0 or not plan.tasks["robot1"].is_empty


@pytest.mark.parametrize("name", labs.SUITE.cases("", Path()))
def test_a_lab_asks_something_of_any_planner(name):
    file = SUITE_FOLDER / f"{labs.SUITE.scenario.format(case=name)}.yaml"
    for planner in (f"{{launch: {FOLLOWER}}}", f"{{python: '{CLASSES}:Follower'}}"):
        plan = make_plan(str(file), settings=[f"cars.robot1.driver={planner}"])
        assert len(plan.scenario.description) > 200
        assert not plan.tasks["robot1"].is_empty


def test_every_module_of_a_suite_is_offered():
    files = {each.stem for each in Path(encounters.__file__).parent.glob("*.py")}
    assert files - {"__init__", "made_places", "scorecard", "suite"} == set(SUITES)


def test_a_track_is_driven_in_both_directions_from_the_same_start_with_both_models(data, tmp_path):
    cases = tracks.SUITE.cases("", tmp_path)
    assert sorted(cases) == [
        "Square_reverse_single_track",
        "Square_reverse_single_track_drift",
        "Square_single_track",
        "Square_single_track_drift",
    ]
    plans = [planned(tracks.SUITE, cases[f"Square{way}_single_track"]) for way in ("", "_reverse")]
    assert {plan.scenario.laps for plan in plans} == {3}
    starts = [plan.cars["robot1"].start for plan in plans]
    assert [(start.x, start.y) for start in starts] == [(0.0, 0.0), (0.0, 0.0)]
    assert [start.yaw for start in starts] == pytest.approx([0.0, np.pi / 2])
    course = read_course(tmp_path / "Square_reverse_centerline.csv")
    assert course.y.tolist() == [0.0, 4.0, 4.0, 0.0]
    assert (course.right[0], course.left[0]) == (2.0, 1.0)


def test_a_line_for_others_is_written_beside_the_place(data, tmp_path):
    line = np.column_stack([SQUARE, [1.0, 2.0, 3.0, 4.0]])
    course = read_course(data / "Square_centerline.csv")
    world = made_places.write_place(tmp_path / "made", data / "Square_map.yaml", course, line)
    rows = np.loadtxt(tmp_path / "made_raceline.csv", delimiter=";")
    assert rows[:, [1, 2, 5]].tolist() == line.tolist()
    assert planned(tracks.SUITE, [f"world={world}"]).cars


@pytest.mark.parametrize("manner", ["middle", "side", "weaves", "brakes", "stands"])
def test_the_other_of_an_encounter_drives_as_its_manner_says(manner):
    encounter = encounters.Encounter("Square", 0.0, manner, speed=2.0, aside=-0.4, brakes_after=10.0)
    x = np.arange(0.0, 40.0, 0.25)
    road = Course(x, np.zeros_like(x), np.ones_like(x), np.ones_like(x))
    line = encounters.line_of(encounter, road)
    far = x > 10.0
    assert np.allclose(line[x <= 6.0, 1], 0.0)
    aside = {"side": (-0.4, -0.4), "weaves": (-0.3, 0.3)}.get(manner, (0.0, 0.0))
    assert (line[far, 1].min(), line[far, 1].max()) == pytest.approx(aside, abs=1e-3)
    assert set(line[x > 16.0, 2]) == {0.0 if manner in ("brakes", "stands") else 2.0}
    assert set(line[x < 16.0, 2]) == {0.0 if manner == "stands" else 2.0}


def test_encounters_begin_where_their_seed_says(data, tmp_path):
    cases = encounters.SUITE.cases("0,2", tmp_path)
    assert [name.split("_")[:2] for name in cases] == [["000", "Square"], ["002", "Square"]]
    starts = []
    for settings in cases.values():
        plan = planned(encounters.SUITE, settings)
        start, other = (plan.cars[name].start for name in ("robot1", "robot2"))
        assert 2.0 < np.hypot(other.x - start.x, other.y - start.y) < 6.001
        assert plan.cars["robot2"].line.name.endswith("_raceline.csv")
        starts.append(start)
    assert starts[0] != starts[1]


def test_among_furniture_neither_goals_nor_the_other_touch_it():
    made = [encounters.make_encounter(seed) for seed in range(1, 200, 2)]
    among = [each for each in made if each.place == "circuit_detailed"]
    assert {each.begin for each in among} == {0.0}
    assert {each.manner for each in among} == {"stands"}
    others = [each for each in made if each.place != "circuit_detailed"]
    assert min(each.begin for each in others) > 0.0
    assert {each.manner for each in others} == {"middle", "side", "weaves", "brakes", "stands"}


def test_safety_lets_each_input_and_each_pair_be_missing_and_late():
    cases = safety.SUITE.cases("", Path())
    plans = [planned(safety.SUITE, settings) for settings in cases.values()]
    assert len(plans) == 36
    faults = [plan.scenario.cars[0].input_faults for plan in plans]
    assert {len(fault.inputs) for (fault,) in faults} == {1, 2}
    assert {fault.delay for (fault,) in faults} == {None, safety.DELAY}
    assert {(fault.at, fault.until) for (fault,) in faults} == {(safety.BEGIN, safety.END)}


def row(case, passed=True, clearance=0.3):
    return {
        "case": case,
        "verdict": "success" if passed else "collision",
        "passed": passed,
        "minimum_clearance": clearance,
        "lap_time": None,
        "of_reference": None,
        "reason": "why",
    }


def test_the_worst_case_is_shown_first():
    rows = [row("good"), row("near", clearance=0.1), row("hit", passed=False, clearance=None)]
    assert [each["case"] for each in scorecard.worst_first(rows)] == ["hit", "near", "good"]
    lines = scorecard.scorecard(rows).splitlines()
    assert [line.split()[0] for line in lines] == ["case", "hit", "near", "good"]
    even = [row("b", passed=False, clearance=1e-5), row("a", passed=False, clearance=1e-4)]
    assert [each["case"] for each in scorecard.worst_first(even)] == ["a", "b"]
    many = [row(f"good{i}") for i in range(30)] + [row(f"hit{i}", passed=False) for i in range(12)]
    assert sum("hit" in line for line in scorecard.scorecard(many).splitlines()) == 12


def test_a_suite_is_run_counted_and_not_run_again(program, tmp_path, capsys):
    results = tmp_path / "results"
    arguments = ["suite", "safety", "--cases", "late_tf_1,missing_scan_8", "--results", str(results)]
    assert cli.main(arguments) == 0
    out = capsys.readouterr().out
    assert "passed:            2 of 2 (100%" in out
    folder = results / "suite" / "safety"
    page = (folder / "index.html").read_text()
    assert '<a href="report.html#late_tf_1">late_tf_1</a>' in page
    linked = re.findall(r'<a href="([a-z.]+)">', page)
    assert linked
    assert all((folder / each).is_file() for each in linked)
    assert "<td>planner</td><td>race (launch file)</td>" in page
    assert (folder / "report.html").is_file()
    cases = ElementTree.parse(folder / "junit.xml").getroot().iter("testcase")
    assert [each.get("name") for each in cases] == ["test_late_tf_1", "test_missing_scan_8"]
    table = (folder / "scorecard.csv").read_text().splitlines()
    assert [line.split(",")[0] for line in table] == ["case", "late_tf_1", "missing_scan_8"]
    ran = len(program.runs())
    assert cli.main(arguments) == 0
    assert len(program.runs()) == ran == 2


def test_each_case_is_run_with_each_of_several_seeds(program, tmp_path, capsys):
    arguments = ["suite", "safety", "--cases", "late_tf_1,missing_scan_8", "--seeds", "2,3", "--jobs", "4"]
    assert cli.main([*arguments, "--results", str(tmp_path)]) == 1
    assert "passed:            2 of 4 (50%" in capsys.readouterr().out
    assert sorted(program.runs())[:2] == ["late_tf_1,seed=2", "late_tf_1,seed=3"]


def test_cases_are_repeated_and_counted_once(program, tmp_path, capsys):
    arguments = ["suite", "safety", "--cases", "late_tf_1,missing_scan_8", "--repeat", "3", "--jobs", "4"]
    assert cli.main([*arguments, "--results", str(tmp_path)]) == 0
    out = capsys.readouterr().out
    assert "repeated:          3 times each, 2 of 2 repeatable\n" in out
    assert "passed:            2 of 2 (100%" in out
    assert sorted(program.runs())[:3] == ["late_tf_1", "late_tf_1,repeat=2", "late_tf_1,repeat=3"]


def test_a_case_that_differs_when_it_is_repeated_is_named(program, tmp_path, capsys):
    program.drifts()
    arguments = ["suite", "safety", "--cases", "late_tf_1", "--repeat", "2", "--results", str(tmp_path)]
    assert cli.main(arguments) == 1
    out, err = capsys.readouterr()
    assert "passed:            1 of 1 (100%" in out
    assert "late_tf_1: not repeatable: trajectories: 2 different ones: does the planner ask the wall " in err


def test_cases_that_fail_are_the_exit_code(program, tmp_path, capsys):
    arguments = ["suite", "safety", "--cases", "late_tf_1", "--set", "seed=2", "--results", str(tmp_path)]
    assert cli.main(arguments) == 1
    assert "passed:            0 of 1" in capsys.readouterr().out


def test_a_road_never_seen_is_driven_by_a_class(tmp_path, capsys):
    pytest.importorskip("shapely")
    arguments = ["suite", "roads", "--cases", "3", "--planner", f"{CLASSES}:Follower", "--workers", "1"]
    assert cli.main([*arguments, "--set", "limits.timeout=0.2", "--results", str(tmp_path)]) == 1
    out = capsys.readouterr().out
    assert "passed:            0 of 2 (0%; 95 % interval 0% to 66%)" in out
    assert out.count("not finished after 0.2 s of simulated time; robot1 ") == 2


def test_suites_are_listed(capsys):
    assert cli.main(["suite"]) == 0
    listed = [line.split()[0] for line in capsys.readouterr().out.splitlines()]
    assert {*SUITES} <= {*listed}
    assert listed == sorted(listed)


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["labs", "--cases", "slalom"], "--cases slalom: found 'slalom', allowed: emergency_braking, "),
        (["safety", "--workers", "0"], "--jobs is 0, must be at least 1"),
        (["safety", "--repeat", "1"], "--repeat is 1, must be at least 2"),
        (
            ["safety", "--cases", "scan"],
            "--cases scan: found 'scan', allowed: missing_scan_1, ",
        ),
        (["encounters", "--cases", "x"], "--cases x: found 'x', must be a seed, a whole number"),
        (["encounters", "--cases", "1.5"], "--cases 1.5: found '1.5', must be a seed, a whole number"),
        (["pace", "--opponent", FOLLOWER], "--opponent is for the suite 'encounters'"),
        (["laps"], "no suite 'laps'; there are: encounters, labs, pace, "),
        (["tracks", "--cases", "Circle"], "Circle_centerline.csv: no such file"),
        (["pace", "--set", "laps=0", "--cases", "circuit1"], "laps is 0, must be at least 1"),
    ],
)
def test_what_cannot_be_run_is_refused_before_anything_runs(
    data, program, tmp_path, capsys, arguments, problem
):
    assert cli.main(["suite", *arguments, "--results", str(tmp_path / "r")]) == 2
    assert problem in capsys.readouterr().err
    assert program.runs() == []


def test_tracks_without_data_are_bad_input(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("F1TENTH_DATA", str(tmp_path))
    assert cli.main(["suite", "tracks", "--results", str(tmp_path)]) == 2
    assert f"{tmp_path}/tracks: not found; F1TENTH_DATA must name" in capsys.readouterr().err
