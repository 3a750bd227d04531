"""Leagues, with a program in the place of real runs."""

from pathlib import Path

import pytest
from f1tenth_judge.league.league_file import read_league
from f1tenth_judge.league.page import league_page
from f1tenth_judge.league.races import Meeting, meetings
from f1tenth_judge.league.standings import standings

from f1tenth_judge import cli

CLASSES = Path(__file__).parents[1] / "drivers" / "python" / "classes.py"
TEXT = f"""
planners:
  - {{name: one, planner: {CLASSES}:Follower}}
  - {{name: two, planner: {CLASSES}:Pursuer, arguments: {{gain: "2"}}}}
places: [circuit1, circuit3]
"""


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "cup.yaml"
    path.write_text(TEXT)
    return path


def run(file, *more):
    return cli.main(["league", str(file), "--results", str(file.parent), *more])


def test_every_planner_races_at_every_place_once_and_is_ranked_on_a_page(file, program, capsys):
    assert run(file) == 0
    races = sorted(program.runs())
    assert races == ["one-circuit1-1", "one-circuit3-1", "two-circuit1-1", "two-circuit3-1"]
    out = capsys.readouterr().out
    assert "  1  one                     2 of 2 finished, pace 1.000\n" in out
    page = (file.parent / "league" / "cup" / "index.html").read_text()
    assert '<a href="report.html#two-circuit3-1">two</a>' in page
    assert "<td>10.000 s</td>" in page
    assert f"<td>{CLASSES}:Follower</td>" in page
    assert "No result" not in page
    assert "<th>won</th>" not in page
    assert (file.parent / "league" / "cup" / "report.html").is_file()
    assert run(file) == 0
    assert sorted(program.runs()) == races


def test_a_run_that_broke_down_is_no_try_and_is_run_again(file, program, capsys):
    text = program.path.read_text()
    broken = '"verdict": "error", "culprit": {"culprit": "runner"}'
    program.path.write_text(text.replace('"culprit": None', broken).replace('"verdict": "success",', ""))
    assert run(file) == 1
    assert "one-circuit1-1: not counted: ok" in capsys.readouterr().err
    program.path.write_text(text)
    assert run(file) == 0
    assert len(program.runs()) == 8


def test_the_page_tells_what_is_missing(file, program):
    file.write_text(f"{TEXT}seeds: [1, 13]\n")  # the second of which is bad luck
    assert run(file) == 1
    page = (file.parent / "league" / "cup" / "index.html").read_text()
    assert "<p>No result yet: 4 of 8 races.</p>" in page


def test_the_page_tells_who_won_where_pairs_race(file):
    file.write_text(f"{TEXT}pairs: true\n")
    league = read_league(file)
    assert "<th>won</th>" in league_page("League", league, standings(league, {}), {}, {})


def test_one_more_planner_takes_part_with_the_seeds_of_the_command(file, program, capsys, monkeypatch):
    monkeypatch.chdir(CLASSES.parent)
    more = ["--planner", f"{CLASSES.name}:Follower", "--seeds", "2:3", "--repeat", "2"]
    run(file, *more, "--jobs", "4")
    assert len(program.runs()) == 3 * 2 * 2 * 2
    assert {"Follower-circuit1-2", "Follower-circuit1-3,repeat=2"} <= set(program.runs())
    assert "repeated:          2 times each, 12 of 12 repeatable\n" in capsys.readouterr().out


def test_a_command_of_ros2_takes_part(file):
    file.write_text(TEXT.replace("two, planner", "two, ros2").replace(f"{CLASSES}:Pursuer", "my_node"))
    assert read_league(file).planners[1].driver(file.parent).ros2 == "my_node"


def test_pairs_meet_once_at_each_place(file):
    file.write_text(f"{TEXT}pairs: true\nseeds: [1, 2]\n")
    found = list(meetings(read_league(file)))
    assert len(found) == 2 * 2 * 3
    assert Meeting(("one", "two"), "circuit3", 2) in found


def result(lap, clearance=0.3, passed=True, winner=None, cars=1):
    return {
        "passed": passed,
        "minimum_clearance": clearance,
        "winner": winner and {"car": winner},
        "cars": {f"robot{car + 1}": {"lap_times": [lap] if lap else []} for car in range(cars)},
    }


def test_who_finishes_most_is_before_who_is_fastest(file):
    results = {
        Meeting(("one",), "circuit1", 1): result(12.0),
        Meeting(("one",), "circuit3", 1): result(30.0, clearance=0.1),
        Meeting(("two",), "circuit1", 1): result(10.0),
        Meeting(("two",), "circuit3", 1): result(None, passed=False),
        Meeting(("one", "two"), "circuit1", 1): result(20.0, winner="robot2", cars=2),
    }
    first, second = standings(read_league(file), results)
    assert (first.name, first.finished, first.raced, first.won, first.clearance) == ("one", 2, 2, 0, 0.1)
    assert first.pace == pytest.approx((1.2 + 1.0) / 2)
    assert (second.name, second.finished, second.pace, second.won) == ("two", 1, 1.0, 1)


@pytest.mark.parametrize(
    ("old", "new", "problem"),
    [
        ("name: two", "name: one", "cup.yaml:3: planners has one twice: one, one"),
        ("name: two", "name: t-o", "name is 't-o', must be of letters, digits and '_'"),
        (
            "name: two, planner",
            "name: two, ros2: a, planner",
            "planner or 'ros2' must be given, and not both",
        ),
        ("[circuit1, circuit3]", "[]", "places is empty; at least one is needed"),
        ("circuit3", "circuit9", "no world 'circuit9'; there are: circuit1, "),
        ("circuit3", "a/b_map.yaml", "no such file: {folder}/a/b_map.yaml"),
        (f"{CLASSES}:Pursuer", "none.py:A", "none.py:A: no such file: {folder}/none.py; allowed: "),
        ("places:", "sites:", "unknown key 'sites'; allowed: planners, places, laps, seeds, pairs"),
    ],
)
def test_what_is_wrong_is_said_before_anything_runs(file, program, capsys, old, new, problem):
    file.write_text(TEXT.replace(old, new))
    assert run(file) == 2
    assert problem.format(folder=file.parent) in capsys.readouterr().err
    assert program.runs() == []


def test_a_planner_of_the_command_needs_a_name_of_its_own(file, program, capsys):
    file.write_text(TEXT.replace("name: one", "name: Follower"))
    assert run(file, "--planner", f"{CLASSES}:Follower") == 2
    expected = f"{file}: with the options: planners has one twice: Follower, two, Follower"
    assert expected in capsys.readouterr().err
    assert program.runs() == []
