"""A world must be found by name or path, or be refused with the names there are."""

import itertools
import re

import pytest
from f1tenth_gazebo.worlds.find_world import WorldError, find_world, main


@pytest.fixture
def worlds(tmp_path, monkeypatch):
    monkeypatch.setenv("GAZEBO_MODEL_PATH", "")
    folder = tmp_path / "package" / "worlds"
    folder.mkdir(parents=True)
    for name in ("b", "a"):
        (folder / f"{name}.world").write_text("")
    return folder


def test_a_name_means_a_world_of_the_package(worlds, tmp_path):
    assert find_world("a", worlds, tmp_path) == worlds / "a.world"


def test_a_path_may_be_relative_or_absolute(worlds, tmp_path):
    (tmp_path / "mine.world").write_text("")
    assert find_world("mine.world", worlds, tmp_path) == tmp_path / "mine.world"
    assert find_world("./mine.world", worlds, tmp_path) == tmp_path / "mine.world"
    assert find_world(str(tmp_path / "mine.world"), worlds, "/") == tmp_path / "mine.world"


def test_a_map_is_a_world_too(worlds, tmp_path):
    (tmp_path / "track_map.yaml").write_text("")
    assert find_world("track_map.yaml", worlds, tmp_path) == tmp_path / "track_map.yaml"


def test_a_wrong_name_is_answered_with_the_known_ones(worlds, tmp_path):
    message = "there is no world named 'c'; known names: a, b; a path works, too"
    with pytest.raises(WorldError, match="^" + re.escape(message) + "$"):
        find_world("c", worlds, tmp_path)


def test_a_wrong_path_is_named_in_full(worlds, tmp_path):
    with pytest.raises(
        WorldError, match=f"there is no world file {tmp_path}/sub/c.world; known names: a, b;"
    ):
        find_world("sub/c.world", worlds, tmp_path)


def test_command_prints_the_path_and_nothing_else(worlds, capsys):
    assert main(worlds.parent, ["a"]) == 0
    assert capsys.readouterr().out == str(worlds / "a.world")


def test_command_fails_with_one_line(worlds, capsys):
    assert main(worlds.parent, ["c"]) == 1
    error = "world_file_name: there is no world named 'c'; known names: a, b; a path works, too\n"
    assert capsys.readouterr().err == error


def test_command_checks_what_the_simulator_can_read(worlds, capsys):
    (worlds / "a.world").write_text("<sdf version='1.6'><world name='w'></sdf>")
    assert main(worlds.parent, ["a"]) == 0
    capsys.readouterr()
    assert main(worlds.parent, ["--check", "a"]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"world_file_name: {worlds}/a.world: line 1: malformed XML")
    assert err.count("\n") == 1


def test_checked_world_finds_the_models_of_the_package(worlds, capsys):
    model = worlds.parent / "models" / "cone"
    model.mkdir(parents=True)
    config = "<model><name>cone</name><sdf version='1.6'>model.sdf</sdf></model>"
    (model / "model.config").write_text(config)
    link = "<model name='cone'><link name='link'/></model>"
    (model / "model.sdf").write_text(f"<sdf version='1.6'>{link}</sdf>")
    include = "<include><uri>model://cone</uri></include>"
    (worlds / "a.world").write_text(f"<sdf version='1.6'><world name='w'>{include}</world></sdf>")
    assert main(worlds.parent, ["--check", "a"]) == 0, capsys.readouterr().err


def test_checked_world_finds_meshes_of_other_packages(worlds, tmp_path, monkeypatch, capsys):
    package = tmp_path / "own"
    package.mkdir()
    (package / "package.xml").write_text("<package format='2'><name>own</name></package>")
    corners = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"]
    faces = [
        f"facet normal 0 0 1 outer loop vertex {' vertex '.join(face)} endloop endfacet"
        for face in itertools.combinations(corners, 3)
    ]
    (package / "wall.stl").write_text("\n".join(["solid wall", *faces, "endsolid wall"]))
    geometry = "<geometry><mesh><uri>package://own/wall.stl</uri></mesh></geometry>"
    link = f"<link name='link'><collision name='collision'>{geometry}</collision></link>"
    model = f"<model name='wall'><static>1</static>{link}</model>"
    (worlds / "a.world").write_text(f"<sdf version='1.6'><world name='w'>{model}</world></sdf>")
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path))
    assert main(worlds.parent, ["--check", "a"]) == 0, capsys.readouterr().err


def test_command_without_an_argument_shows_its_usage(worlds, capsys):
    with pytest.raises(SystemExit, match="2"):
        main(worlds.parent, [])
    assert capsys.readouterr().err.startswith("usage: find_world [-h] [--check] NAME|PATH\n")
