"""Planners on DDS alone, judged as those of ROS 2 are: the same drive every time, or what is wrong."""

import csv
import shlex
import sys
from pathlib import Path

import pytest
from f1tenth_judge.places import lookup
from f1tenth_judge.places.map_file import load_map
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.record.replay import Drawing, read_replay
from f1tenth_judge.run.stage import Stage
from f1tenth_judge.scenario.driver import Driver

PLANNERS = Path(__file__).parent / "planners"


def command(file, how):
    return shlex.join([sys.executable, str(PLANNERS / f"{file}.py"), how])


def test_planner_drives_a_lap(race):
    result = race(command("gap", "by_subscription"), settings=["limits.timeout=40"])
    assert (result["verdict"], result["lockstep"]) == ("success", True)
    assert result["criteria"]


def test_same_drive_by_one_node_and_by_three(race):
    hashes = {
        race(command("gap", how))["trajectory_hash"]
        for how in ("by_subscription", "by_subscription", "by_three_nodes")
    }
    assert len(hashes) == 1


def test_timers_go_by_simulated_time(race, tmp_path):
    results = [race(command("gap", "by_timer")) for _ in range(2)]
    assert results[0]["trajectory_hash"] == results[1]["trajectory_hash"]
    assert results[0]["note"] == ""
    stamps = [float(line) for line in (tmp_path / "log" / "robot1.log").read_text().splitlines()]
    assert {round(later - earlier, 9) for earlier, later in zip(stamps, stamps[1:])} == {0.05}
    assert len(stamps) > 90


def test_each_planner_hears_its_own_car_and_sees_the_other(race, tmp_path):
    result = race(command("telling", "tells_both"), command("telling", "tells_both"))
    assert set(result["cars"]) == {"robot1", "robot2"}
    first, second = ((tmp_path / "log" / f"robot{n}.log").read_text().splitlines() for n in (1, 2))
    assert len(first) > 150
    assert {line.split()[0]: line.split()[1] for line in first} == {
        line.split()[0]: line.split()[2] for line in second
    }


def test_what_was_sensed_comes_before_the_scan_and_the_time_last(race, tmp_path):
    result = race(command("telling", "tells_what_it_hears"), settings=["limits.timeout=2"])
    assert (result["verdict"], result["lockstep"]) == ("timeout", True)
    told = (tmp_path / "log" / "robot1.log").read_text().splitlines()
    heard = {"scan": [], "clock": [], "imu": [], "odom": [], "ego_racecar/odom": []}
    for place, line in enumerate(told):
        stamp, topic = line.split()
        heard[topic].append((float(stamp), place))
    periods = [round(stamp, 9) for stamp, _ in heard["clock"]]
    assert periods == pytest.approx([n / 40 for n in range(1, len(periods) + 1)])
    assert len(periods) > 75
    for topic in ("odom", "ego_racecar/odom", "scan"):
        assert [round(stamp, 9) for stamp, _ in heard[topic]] == periods
    assert len(heard["imu"]) == 5 * len(periods)
    for number, (_, clock) in enumerate(heard["clock"]):
        scan = heard["scan"][number][1]
        sensed = [heard["odom"][number], heard["ego_racecar/odom"][number], heard["imu"][5 * number + 4]]
        assert max(place for _, place in sensed) < scan < clock
    with (tmp_path / "trajectory.csv").open() as record:
        last = list(csv.DictReader(record))[-1]
    assert float(last["v_x"]) == pytest.approx(0.5, abs=0.05)


WRONG = {
    "ends_at_once": "ended with exit code 0; its last words: nothing to do",
    "dies_at_once": "ended with exit code 1; it raised ValueError: no model weights in /models",
    "raises_in_callback": "exit code 1; it raised AttributeError: 'LaserScan' object has no attribute",
    "is_silent": "has sent no command at all for 2 s of simulated time (limits.silence); no node of it",
    "says_nan": "that the simulator refuses (at 2 s): robot1: commanded speed (m/s) is nan",
    "floods": "sends 4000 commands per second of simulated time (at 1 s), may be 400",
    "hangs_in_callback": "has not come to rest within 2 s of wall time (limits.answer)",
    "sends_elsewhere": "publishes ackermann_msgs/msg/AckermannDriveStamped on /nav, which nobody hears; the",
    "sends_twists": "publishes geometry_msgs/msg/Twist on /drive, which is ackermann_msgs/msg/Ackermann",
    "hears_another_type": "hears sensor_msgs/msg/Imu on /scan, which is sensor_msgs/msg/LaserScan; hears /li",
    "sends_best_effort": "does not match by its QoS: requested reliable, the planner offers best effort",
    "hears_latched_scans": "/scan does not match by its QoS: requested transient local, the car offers vol",
}


@pytest.mark.parametrize(("how", "reason"), WRONG.items(), ids=list(WRONG))
def test_planner_that_goes_wrong_is_named_with_the_reason(race, how, reason):
    settings = ["limits.silence=2", "limits.answer=2"]
    result = race(command("misbehaving", how), settings=settings)
    assert (result["verdict"], result["culprit"]["culprit"]) == ("error", "robot1/planner")
    assert reason in result["reason"]


def test_last_words_and_what_was_set_are_kept(race, tmp_path):
    result = race(command("misbehaving", "is_silent"), settings=["limits.silence=1"])
    assert result["culprit"]["log_lines"] == ["waiting for a joystick"]
    assert result["culprit"]["log_file"] == "log/robot1.log"
    assert "ROS_DOMAIN_ID=" in (tmp_path / "log" / "robot1.env").read_text()


def test_planner_that_goes_by_the_wall_clock_is_run_in_real_time_and_that_is_said(race):
    result = race(command("misbehaving", "goes_by_the_wall_clock"))
    assert (result["verdict"], result["lockstep"]) == ("timeout", False)
    assert result["note"].startswith(
        "run in real time, as the driver of robot1 does not fit lockstep: it sends commands"
    )
    assert "hears /clock" in result["note"]


@pytest.mark.parametrize(
    ("how", "repeatable", "note"),
    [
        ("contradicts_itself", True, "robot1: no node of it hears"),
        ("is_of_two_minds", False, "not repeatable, as at 0."),
    ],
)
def test_run_in_which_processes_race_to_command_is_not_called_repeatable(race, how, repeatable, note):
    result = race(command("misbehaving", how), settings=["limits.timeout=2"])
    assert (result["verdict"], result["repeatable"]) == ("timeout", repeatable)
    assert result["note"].startswith(note)


def test_planner_does_not_move_the_car_by_hand(race):
    result = race(command("misbehaving", "puts_itself_elsewhere"), settings=["limits.timeout=2"])
    assert result["verdict"] == "timeout"
    assert "robot1: /initialpose moves no car in a judged run" in result["note"]


def test_what_does_not_fit_is_noted_though_the_planner_drives(race):
    result = race(command("misbehaving", "hears_latched_odometry"), settings=["limits.timeout=2"])
    assert result["verdict"] == "timeout"
    assert "/odom does not match by its QoS: requested transient local" in result["note"]


def test_map_and_transforms_are_there_for_those_who_come_late(race, tmp_path):
    race(command("telling", "tells_where_all_is"), settings=["limits.timeout=2"])
    told = (tmp_path / "log" / "robot1.log").read_text().splitlines()
    grid = load_map(lookup.map_file(lookup.world_file("circuit1", tmp_path)))
    assert sorted(told) == [
        "ego_racecar/base_link ego_racecar/laser",
        "ego_racecar/base_link ego_racecar/stereo_camera/left",
        "ego_racecar/base_link ego_racecar/stereo_camera/right",
        f"map {grid.cells.shape[1]} {grid.cells.shape[0]} {int(grid.cells.sum())}",
        "map ego_racecar/base_link",
    ]


def test_what_a_planner_draws_and_counts_is_in_the_replay(race, tmp_path):
    result = race(command("telling", "draws"), settings=["limits.timeout=3"])
    beams = {"least": 1081.0, "greatest": 1081.0, "last": 1081.0}
    assert result["cars"]["robot1"]["channels"] == {"/debug/beams": beams}
    assert "cannot be read" not in result["note"]
    drawn = read_replay(tmp_path / "replay.json.gz").drawings
    assert drawn["/way"].values == [[Drawing("", [[[0.0, 1.0], [2.0, 1.0]]], [], [])]]
    (target,) = drawn["/debug/target"].values[0]
    ((x, y, radius),) = target.dots
    lidar = Stage(plan_race(Race("circuit1", 1, [Driver(ros2="none")]), tmp_path / "other")).lidar("robot1")
    assert target.colour == "#ff0000"
    assert (x, y, radius) == (pytest.approx(lidar.pose[0], abs=0.7), pytest.approx(0.0, abs=0.1), 0.1)
    assert len(drawn["/debug/target"].stamps) > 5


def test_pictures_come_whole_and_are_the_same_every_time(race, tmp_path):
    told = []
    for _ in range(2):
        race(command("telling", "tells_pictures"), settings=["limits.timeout=1"])
        told.append((tmp_path / "log" / "robot1.log").read_text().splitlines())
    assert told[0] == told[1]
    eye = "ego_racecar/stereo_camera/right"
    for kind in (f"rgb8 672 376 2016 {eye}", f"32FC1 672 376 2688 {eye}", "info 336.268 0.0 335.5"):
        stamps = [float(line.split()[0]) for line in told[0] if f" {kind} " in line]
        assert stamps == pytest.approx([n / 20 for n in range(1, 20)])
    assert any(line.endswith(" 336.268 0.0 335.5 -40.352") for line in told[0])


def test_pictures_that_may_be_lost_are_noted(race):
    result = race(command("telling", "hears_pictures_best_effort"), settings=["limits.timeout=1"])
    assert "robot1: /stereo_camera/left/image_raw is heard best effort: on a busy" in result["note"]
