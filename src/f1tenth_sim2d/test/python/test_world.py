from pathlib import Path

import numpy as np
import pytest

import f1tenth_sim2d


def test_world_names_its_models(world):
    assert world.name == "room"
    assert [model.name for model in world.models] == ["wall", "post", "crate"]
    assert [model.is_static for model in world.models] == [True, True, False]
    assert world.models[2].pose == pytest.approx((0.0, -3.0, 0.5))
    assert world.models[0].collisions == ["wall::link::collision"]
    assert world.warnings == []


def test_section_holds_outlines_and_circles_of_static_models(world):
    outlines, circles = world.section(0.2)
    assert len(outlines) == 1
    assert outlines[0].shape == (4, 2)
    assert outlines[0].dtype == np.float64
    np.testing.assert_allclose(np.sort(np.unique(outlines[0][:, 0].round(9))), [4.9, 5.1])
    np.testing.assert_allclose(circles, [[0.0, 3.0, 0.25]])


def test_section_above_everything_is_empty(world):
    outlines, circles = world.section(2.0)
    assert outlines == []
    assert circles.shape == (0, 3)


def test_section_at_no_height_is_a_value_error(world):
    with pytest.raises(ValueError, match="^z is not finite$"):
        world.section(float("nan"))


def test_section_of_a_model_is_its_own_at_the_start(world):
    wall, post, crate = world.models
    assert wall.section(0.2)[0][0].tolist() == world.section(0.2)[0][0].tolist()
    assert post.section(0.2)[1].tolist() == [[0.0, 3.0, 0.25]]
    (outline,), _ = crate.section(0.2)
    assert outline.mean(axis=0) == pytest.approx((0.0, -3.0))
    with pytest.raises(ValueError, match="^z is not finite$"):
        crate.section(float("inf"))


def test_errors_are_load_errors_with_one_line(tmp_path):
    path = tmp_path / "none.world"
    with pytest.raises(f1tenth_sim2d.LoadError) as raised:
        f1tenth_sim2d.load_world(str(path))
    assert str(raised.value) == f"{path}: no such file"
    assert isinstance(raised.value, f1tenth_sim2d.Error)


def test_model_path_is_looked_through(tmp_path):
    model = tmp_path / "models" / "block"
    model.mkdir(parents=True)
    (model / "model.config").write_text("<model><name>block</name><sdf version='1.6'>model.sdf</sdf></model>")
    (model / "model.sdf").write_text("<sdf version='1.6'><model name='block'><link name='l'/></model></sdf>")
    world = tmp_path / "worlds" / "deep" / "w.world"
    world.parent.mkdir(parents=True)
    world.write_text(
        "<sdf version='1.6'><world name='w'><include><uri>model://block</uri></include></world></sdf>"
    )
    loaded = f1tenth_sim2d.load_world(str(world), model_path=[str(tmp_path / "models")])
    assert [each.name for each in loaded.models] == ["block"]
    with pytest.raises(f1tenth_sim2d.LoadError, match="Unable to find uri"):
        f1tenth_sim2d.load_world(str(world), model_path=[])


def test_model_path_defaults_to_the_environment(tmp_path, monkeypatch):
    (tmp_path / "block").mkdir()
    (tmp_path / "block" / "model.config").write_text(
        "<model><name>block</name><sdf version='1.6'>model.sdf</sdf></model>"
    )
    (tmp_path / "block" / "model.sdf").write_text(
        "<sdf version='1.6'><model name='block'><link name='l'/></model></sdf>"
    )
    world = tmp_path / "worlds" / "w.world"
    world.parent.mkdir()
    world.write_text(
        "<sdf version='1.6'><world name='w'><include><uri>model://block</uri></include></world></sdf>"
    )
    monkeypatch.setenv("GAZEBO_MODEL_PATH", str(tmp_path))
    assert len(f1tenth_sim2d.load_world(str(world)).models) == 1


def test_a_path_may_be_one_of_pathlib(world_file):
    assert f1tenth_sim2d.load_world(Path(world_file)).file == world_file
