"""Packages and their manifests, and that nothing here needs ROS."""

import ast
from pathlib import Path

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import packages

SOURCE = Path(packages.__file__).parents[1]
ROS = {
    "actionlib", "genpy", "rosbag", "rosgraph", "roslaunch", "roslib", "rosmaster", "rosparam", "rospkg",
    "rospy", "rostest", "tf", "tf2_ros", "xacro",
}  # fmt: skip
OWN = {"f1tenth_judge", "f1tenth_sim2d"}


class Fixed:
    def __init__(self, **folders):
        self._folders = folders

    def names(self):
        return list(self._folders)

    def path(self, package):
        return self._folders.get(package)


@pytest.fixture
def known(tmp_path, monkeypatch):
    (tmp_path / "theirs" / "goals").mkdir(parents=True)
    (tmp_path / "theirs" / "goals" / "a.txt").touch()
    (tmp_path / "theirs" / "package.xml").write_text(
        "<package><name>theirs</name><version>1.2.3</version><description>\n Stand-in for x</description>"
        '<export><f1tenth_scenarios goals="${prefix}/goals"/></export></package>'
    )
    (tmp_path / "broken").mkdir()
    (tmp_path / "broken" / "package.xml").write_text("<package>")
    monkeypatch.setattr(packages, "_known", packages._known)
    packages.know_packages(Fixed(theirs=tmp_path / "theirs", broken=tmp_path / "broken"))
    yield tmp_path
    packages.exports.cache_clear()


def imported(file):
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module


def test_nothing_here_imports_ros_or_a_package_that_builds_on_this_one():
    found = {name.split(".")[0] for file in SOURCE.rglob("*.py") for name in imported(file)}
    assert "f1tenth_judge" in found
    assert {name for name in found if name in ROS or name.endswith("_msgs")} == set()
    assert {name for name in found if name.startswith("f1tenth_")} <= OWN


def test_what_a_manifest_says(known):
    assert packages.package_version("theirs") == "1.2.3"
    assert not packages.is_original("theirs")
    assert not packages.is_original("none")
    assert packages.exports("f1tenth_scenarios", "goals") == [known / "theirs" / "goals"]
    assert packages.exports("f1tenth_scenarios", "worlds") == []
    assert packages.package_version("none") is None


def test_a_file_is_in_the_package_that_is_found_there(known):
    file = known / "theirs" / "goals" / "a.txt"
    assert packages.in_package(file) == ("theirs", Path("goals/a.txt"))
    copy = known / "copy"
    copy.mkdir()
    (copy / "package.xml").write_text("<package><name>theirs</name></package>")
    (copy / "b.txt").touch()
    assert packages.in_package(copy / "b.txt") is None
    assert packages.in_package(known / "elsewhere.txt") is None


def test_a_package_that_is_not_there_is_named(known):
    with pytest.raises(ScenarioError, match="package none not found; is the workspace's setup.bash sourced"):
        packages.package_path("none")


def test_without_ros_the_workspace_s_own_packages_are_known(monkeypatch):
    monkeypatch.setattr(packages, "_known", packages._Beside())
    assert (packages.package_path("f1tenth_gazebo") / "circuits").is_dir()
    assert "f1tenth_gazebo" in packages.package_names()
