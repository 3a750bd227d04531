"""The node drive_lap before the drive and after it; without a master."""

from io import BytesIO
from types import SimpleNamespace

import pytest
import rospy
from f1tenth_gazebo.driving import lap_driver
from f1tenth_judge.places.map_file import load_map
from nav_msgs.msg import MapMetaData, OccupancyGrid


@pytest.mark.parametrize(
    ("given", "found"), [({}, ""), ({"~map_file": "."}, "."), ({"~map_file": "maps/.."}, "maps/..")]
)
def test_map_file_that_is_missing_or_has_no_name_is_one_line(monkeypatch, capsys, given, found):
    def get_param(name, *default):
        if name not in given and not default:
            raise KeyError(name)
        return given.get(name, *default)

    monkeypatch.setattr(lap_driver.rospy, "init_node", lambda name: None)
    monkeypatch.setattr(lap_driver.rospy, "has_param", lambda name: name in given)
    monkeypatch.setattr(lap_driver.rospy, "get_param", get_param)
    monkeypatch.setattr(lap_driver.rospy, "resolve_name", lambda name: name.replace("~", "/drive_lap/"))
    monkeypatch.setattr(lap_driver, "LapDriver", lambda *_: pytest.fail("has begun"))
    assert lap_driver.main() == 2
    assert capsys.readouterr().err == (
        f"drive_lap: /drive_lap/map_file: found '{found}',"
        " must be a path without extension that ends with a name\n"
    )


def map_with(cell):
    return OccupancyGrid(info=MapMetaData(resolution=0.05, width=1, height=1), data=[cell])


@pytest.fixture
def keeper(monkeypatch):
    """Has heard a map with a free cell."""
    hear = []
    monkeypatch.setattr(rospy, "Subscriber", lambda _topic, _kind, callback, **_: hear.append(callback))
    keeper = lap_driver.MapKeeper()
    heard = BytesIO()
    map_with(0).serialize(heard)
    hear[0](SimpleNamespace(_buff=heard.getvalue()))
    return keeper


def test_map_is_that_of_a_mapper_that_has_taken_in_all_scans(keeper, monkeypatch, tmp_path):
    answers = iter([map_with(0), map_with(100)])  # the first is given while scans wait
    monkeypatch.setattr(rospy, "ServiceProxy", lambda *_: lambda: SimpleNamespace(map=next(answers)))
    keeper.wait_for_mapper()
    assert keeper.save(tmp_path / "new")
    assert load_map(tmp_path / "new.yaml").cells.tolist() == [[100]]


def test_map_of_a_mapper_without_the_service_is_the_last_one_heard(keeper, monkeypatch, tmp_path):
    def fail():
        raise rospy.ServiceException("service [/dynamic_map] unavailable")

    warnings = []
    monkeypatch.setattr(rospy, "ServiceProxy", lambda *_: fail)
    monkeypatch.setattr(rospy, "logwarn", warnings.append)
    keeper.wait_for_mapper()
    assert keeper.save(tmp_path / "old")
    assert load_map(tmp_path / "old.yaml").cells.tolist() == [[0]]
    assert warnings == ["The mapper does not tell when it is done: its last map on /map counts"]
