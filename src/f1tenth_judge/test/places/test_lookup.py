"""Files that are named in the place of others are told apart before anything starts."""

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup

MAP = "image: a.png\nresolution: 0.05\n"
SCENARIO = "world: circuit1\ncars:\n  - name: robot1\n"
WORLD = "<?xml version='1.0'?>\n<sdf/>"


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.yaml", MAP),
        ("a.yml", "{image: a.png, resolution: 0.05}"),
        ("a.world", "\ufeff" + WORLD),
        ("a", WORLD),
    ],
)
def test_a_place_is_found_and_is_no_scenario(tmp_path, name, text):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    assert lookup.world_file(str(path), tmp_path) == path
    with pytest.raises(ScenarioError) as refused:
        lookup.scenario_file(str(path))
    assert str(refused.value) == f"{path} is a place, not a scenario: `f1tenth race {path}`"


@pytest.mark.parametrize(
    ("name", "text", "problem"),
    [
        ("a.yaml", SCENARIO, "is a scenario: `f1tenth run {path}`"),
        ("a.yaml", "corners: []\n", "is no map: it has no key 'image'"),
        ("a.txt", "1.0 2.0 0.0\n", "is no world: it does not begin as SDF does, with '<'"),
        ("a.world", "", "is no world: it does not begin as SDF does, with '<'"),
    ],
)
def test_what_is_no_place_is_told_by_what_it_is(tmp_path, name, text, problem):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ScenarioError) as refused:
        lookup.world_file(str(path), tmp_path)
    assert str(refused.value) == f"{path} {problem.format(path=path)}"


def test_a_scenario_that_is_named_by_its_path_is_one(tmp_path):
    path = tmp_path / "a.yaml"
    path.write_text(SCENARIO, encoding="utf-8")
    assert lookup.scenario_file(str(path)) == path
