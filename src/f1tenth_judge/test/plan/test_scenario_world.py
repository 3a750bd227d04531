"""Boxes of a scenario in the world that is simulated."""

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.scenario_world import check_boxes, write_world
from f1tenth_judge.scenario.scenario import Box
from scenario_samples import scenario

import f1tenth_sim2d

WORLD = '<sdf version="1.7"><world name="w"><model name="wall"><static>1</static></model></world></sdf>\n'
FIXED = Box("block", 1.0, 2.0, length=0.4, width=0.2)
LOOSE = Box("crate", 3.0, 0.0, yaw=0.5, movable=True, mass=2.0)


@pytest.fixture
def world(tmp_path):
    path = tmp_path / "my.world"
    path.write_text(WORLD, encoding="utf-8")
    return path


def test_boxes_are_where_and_what_they_should_be(world, tmp_path):
    write_world(world, scenario(boxes=(FIXED, LOOSE)), tmp_path / "boxes.world")
    models = {model.name: model for model in f1tenth_sim2d.load_world(str(tmp_path / "boxes.world")).models}
    assert models["block"].is_static
    (outline,), _ = models["block"].section(0.2)
    assert sorted(map(tuple, outline.round(6))) == [(0.8, 1.9), (0.8, 2.1), (1.2, 1.9), (1.2, 2.1)]
    assert not models["crate"].is_static
    assert models["crate"].pose == pytest.approx((3.0, 0.0, 0.5))
    assert models["crate"].mass == 2.0


def test_name_of_a_model_is_refused(world):
    with pytest.raises(ScenarioError, match=r"boxes\[0\]\.name is 'wall', and .* has a model of that name"):
        check_boxes(world, scenario(boxes=(Box("wall", 0.0, 0.0),)))


@pytest.mark.parametrize("text", ["nonsense", "<sdf/>"])
def test_world_that_is_no_sdf_takes_no_boxes(tmp_path, text):
    path = tmp_path / "bad.world"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(ScenarioError, match=f"boxes need a world in SDF, and {path} "):
        check_boxes(path, scenario(boxes=(FIXED,)))


def test_without_boxes_any_world_will_do(tmp_path):
    check_boxes(tmp_path / "map.yaml", scenario())
