import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
MANIFEST = "<package><name>map_server</name><description>{}</description></package>"


@pytest.fixture
def workspace(tmp_path):
    """Return a workspace with one stand-in, called map_server."""
    (tmp_path / "ws" / "cmake").mkdir(parents=True)
    shutil.copy(ROOT / "cmake" / "standins.cmake", tmp_path / "ws" / "cmake")
    standin = tmp_path / "ws" / "src" / "standins" / "map_server"
    standin.mkdir(parents=True)
    (standin / "package.xml").write_text(MANIFEST.format("Maps"))
    return tmp_path / "ws"


def leave_out(workspace, **environment):
    clean = {k: v for k, v in os.environ.items() if k not in ("CMAKE_PREFIX_PATH", "ROS_PACKAGE_PATH")}
    command = ["cmake", "-P", workspace / "cmake" / "standins.cmake"]
    subprocess.run(command, env={**clean, **environment}, check=True, capture_output=True)
    return workspace / "src" / "standins" / "map_server" / "CATKIN_IGNORE"


def install_original(prefix, folder="share"):
    package = prefix / folder / "map_server"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(MANIFEST.format("Maps"))
    return package


def test_a_standin_is_built_where_the_original_is_not_installed(workspace):
    assert not leave_out(workspace).exists()


def test_a_standin_is_left_out_where_the_original_is_under_a_prefix(workspace, tmp_path):
    package = install_original(tmp_path / "noetic")
    ignore = leave_out(workspace, CMAKE_PREFIX_PATH=f"{tmp_path / 'devel'}:{tmp_path / 'noetic'}")
    assert str(package) in ignore.read_text()


def test_a_standin_is_left_out_where_the_original_is_on_the_package_path(workspace, tmp_path):
    install_original(tmp_path / "noetic")
    assert leave_out(workspace, ROS_PACKAGE_PATH=str(tmp_path / "noetic" / "share")).exists()


def test_a_standin_is_left_out_where_the_original_is_anywhere_in_another_workspace(workspace, tmp_path):
    package = install_original(tmp_path / "other ws", "src/navigation")
    for own in (workspace / "src", workspace, workspace / "src" / "standins"):
        ignore = leave_out(workspace, ROS_PACKAGE_PATH=f"{own}:{tmp_path / 'other ws' / 'src'}")
        assert str(package) in ignore.read_text()
        ignore.unlink()


def test_an_original_that_rospack_does_not_look_at_does_not_count(workspace, tmp_path):
    package = install_original(tmp_path / "other", "src/navigation")
    (package / "CATKIN_IGNORE").touch()
    assert not leave_out(workspace, ROS_PACKAGE_PATH=str(tmp_path / "other" / "src")).exists()


def test_a_standin_comes_back_when_the_original_is_gone(workspace, tmp_path):
    package = install_original(tmp_path / "noetic")
    prefix = str(tmp_path / "noetic")
    assert leave_out(workspace, CMAKE_PREFIX_PATH=prefix).exists()
    shutil.rmtree(package)
    assert not leave_out(workspace, CMAKE_PREFIX_PATH=prefix).exists()


def test_a_standin_does_not_mistake_itself_for_the_original(workspace):
    assert not leave_out(workspace, ROS_PACKAGE_PATH=str(workspace / "src" / "standins")).exists()
    assert not leave_out(workspace, ROS_PACKAGE_PATH=str(workspace / "src")).exists()
    assert not leave_out(workspace, ROS_PACKAGE_PATH=str(workspace.parent)).exists()


def test_an_installed_standin_is_not_the_original(workspace, tmp_path):
    package = install_original(tmp_path / "install")
    (package / "package.xml").write_text(MANIFEST.format("Stand-in: maps"))
    assert not leave_out(workspace, CMAKE_PREFIX_PATH=str(tmp_path / "install")).exists()


@pytest.mark.parametrize(
    "manifest", sorted(ROOT.glob("src/standins/*/package.xml")), ids=lambda p: p.parent.name
)
def test_every_standin_says_in_its_description_that_it_is_one(manifest):
    assert "<description>Stand-in" in manifest.read_text()
