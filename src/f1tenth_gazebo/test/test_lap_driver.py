"""The node drive_lap says what is wrong with its parameters before the drive; without a master."""

import pytest
from f1tenth_gazebo.driving import lap_driver


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
