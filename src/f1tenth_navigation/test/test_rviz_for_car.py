from pathlib import Path

import pytest
import yaml
from f1tenth_navigation.rviz_for_car import ConfigError, config_for_car, is_for_car, main

CONFIGS = sorted((Path(__file__).parents[1] / "rviz").glob("*.rviz"))


def displays(config):
    """Return all displays of a configuration, those in groups too."""
    found = []
    waiting = list(config["Visualization Manager"]["Displays"])
    while waiting:
        display = waiting.pop()
        found.append(display)
        waiting.extend(display.get("Displays", []))
    return found


def topics(config):
    """Return the topics of all displays that are switched on."""
    shown = [display for display in displays(config) if display.get("Enabled")]
    return {display[key] for display in shown for key in ("Topic", "Marker Topic") if key in display}


def goal_topics(config):
    tools = config["Visualization Manager"]["Tools"]
    return [tool["Topic"] for tool in tools if tool["Class"] == "rviz/SetGoal"]


def loaded(path, car="robot1", prefix="robot1/"):
    return yaml.safe_load(config_for_car(path, car, prefix))


def test_there_is_a_configuration_for_one_and_for_two_cars():
    assert [path.name for path in CONFIGS] == ["one_car.rviz", "two_cars.rviz"]


@pytest.mark.parametrize("path", CONFIGS, ids=lambda path: path.name)
def test_every_configuration_looks_down_on_the_map(path):
    manager = loaded(path)["Visualization Manager"]
    assert manager["Global Options"]["Fixed Frame"] == "map"
    assert manager["Views"]["Current"]["Class"] == "rviz/TopDownOrtho"


@pytest.mark.parametrize(("path", "cars"), zip(CONFIGS, [["robot1"], ["robot1", "robot2"]]))
def test_every_configuration_shows_what_its_cars_see_and_want(path, cars):
    config = loaded(path)
    shown = topics(config)
    assert "/map" in shown
    for car in cars:
        assert {
            f"/{car}/scan",
            f"/{car}/perfect_odom",
            f"/{car}/move_base/global_plan",
            f"/{car}/move_base/local_plan",
            f"/{car}/move_base/local_costmap/costmap",
            f"/{car}/move_base/global_costmap/costmap",
            f"/{car}/goal_markers",
            f"/{car}/contact_markers",
        } <= shown
    assert goal_topics(config) == [f"/{car}/move_base_simple/goal" for car in cars]
    models = [display for display in displays(config) if display["Class"] == "rviz/RobotModel"]
    assert sorted(model["TF Prefix"] for model in models) == cars


def test_configuration_for_robot1_is_used_as_it_is():
    assert is_for_car("robot1", "robot1/")
    assert is_for_car("robot1", "/robot1")
    assert not is_for_car("robot1", "/")
    assert not is_for_car("ego", "robot1/")
    assert loaded(CONFIGS[0]) == yaml.safe_load(CONFIGS[0].read_text())


def test_another_car_takes_the_place_of_robot1():
    config = loaded(CONFIGS[0], car="ego", prefix="ego/")
    assert "robot1" not in str(config)
    assert "/ego/scan" in topics(config)
    assert goal_topics(config) == ["/ego/move_base_simple/goal"]


def test_car_s_frames_may_have_no_prefix():
    config = loaded(CONFIGS[0], prefix="/")
    model = next(display for display in displays(config) if display["Class"] == "rviz/RobotModel")
    assert (model["TF Prefix"], model["Robot Description"]) == ("", "/robot1/robot_description")


def test_frames_of_a_view_follow_the_car(tmp_path):
    path = tmp_path / "my.rviz"
    path.write_text("Visualization Manager: {Views: {Target Frame: robot1/base_link}}")
    assert (
        loaded(path, car="ego", prefix="/a/")["Visualization Manager"]["Views"]["Target Frame"]
        == "a/base_link"
    )
    assert loaded(path, car="ego", prefix="")["Visualization Manager"]["Views"]["Target Frame"] == "base_link"


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ("a: [", "not an rviz configuration: while parsing"),
        ("", "not an rviz configuration: no Visualization Manager in it"),
        ("a: 1", "not an rviz configuration: no Visualization Manager in it"),
    ],
)
def test_file_that_is_no_configuration_is_refused_in_one_line(tmp_path, content, reason):
    path = tmp_path / "my.rviz"
    path.write_text(content)
    with pytest.raises(ConfigError) as raised:
        loaded(path)
    assert str(raised.value).startswith(f"{path}: {reason}")
    assert "\n" not in str(raised.value)


def test_missing_configuration_ends_with_one_line_and_exit_1(capsys, tmp_path):
    assert main(["rviz_for_car", "--config", str(tmp_path / "none.rviz")]) == 1
    assert capsys.readouterr().err == (
        f"rviz_for_car: {tmp_path}/none.rviz: cannot be opened: No such file or directory\n"
    )
