"""Reading off roslaunch's output which node ended, and who is to blame."""

import pytest
from f1tenth_judge.record.observations import RaceState, RaceUpdate
from f1tenth_scenarios.run.diagnosis.culprit import Signs, failure_of, failure_of_driver
from f1tenth_scenarios.run.diagnosis.launch_log import LaunchLog, NodeEnd
from scenario_samples import sample_plan, scenario

# As roslaunch 1.15 prints it.
DIED = (
    "\033[31m[robot1/move_base-5] process has died [pid 4711, exit code -9, cmd /x/move_base].\n"
    "log file: {log}/robot1-move_base-5*.log\033[0m\n"
)
REQUIRED = (
    "\033[31m" + "=" * 80 + "REQUIRED process [sim2d-2] has died!\n"
    "process has died [pid 4712, exit code 3, cmd /x/sim2d __name:=sim2d].\nlog file: {log}/sim2d-2*.log\n"
    "Initiating shutdown!\n" + "=" * 80 + "\033[0m\n"
)
FINISHED = (
    "\033[1m[race_starter-3] process has finished cleanly\nlog file: {log}/race_starter-3*.log\033[0m\n"
)
REQUIRED_FINISHED = DIED[:5] + "====REQUIRED process [sim2d-2] has died!\nprocess has finished cleanly\n"


def ends_of(tmp_path, *texts):
    path = tmp_path / "roslaunch.log"
    path.write_text("".join(texts).replace("{log}", str(tmp_path)), encoding="utf-8")
    log = LaunchLog(path)
    log.poll()
    return log.ends


def plan(folder):
    made = sample_plan(folder, scenario())
    made.log_folder.mkdir()
    return made


def signs(ends=(), lost=(), exit_code=None, simulator=None):
    return Signs(ends, lost, exit_code, simulator or {})


def test_killed_node_is_seen(tmp_path):
    (end,) = ends_of(tmp_path, DIED)
    assert end == NodeEnd("robot1/move_base", -9, f"{tmp_path}/robot1-move_base-5*.log", package="x")
    assert end.describe() == "was killed by signal 9"


def test_end_of_a_required_node_is_seen(tmp_path):
    (end,) = ends_of(tmp_path, REQUIRED)
    assert end == NodeEnd("sim2d", 3, f"{tmp_path}/sim2d-2*.log", package="x", is_required=True)
    assert end.describe() == 'ended with exit code 3, and is required="true" in its launch file'


def test_end_of_a_node_that_roslaunch_has_not_seen_running_is_seen(tmp_path):
    ends = ends_of(tmp_path, DIED.replace("4711", "-1"), REQUIRED.replace("4712", "-1"))
    assert [(end.node, end.exit_code) for end in ends] == [("robot1/move_base", -9), ("sim2d", 3)]


def test_clean_ends_are_seen(tmp_path):
    assert [(end.node, end.exit_code) for end in ends_of(tmp_path, FINISHED, REQUIRED_FINISHED)] == [
        ("race_starter", 0),
        ("sim2d", 0),
    ]


def test_clean_end_of_a_required_node_says_why_it_ends_the_run(tmp_path):
    (end,) = ends_of(tmp_path, REQUIRED_FINISHED)
    assert end.describe() == 'ended with exit code 0, and is required="true" in its launch file'


def test_package_that_is_not_there_is_named(tmp_path):
    refused = "\033[31mERROR: cannot launch node of type [{0}/{0}_node]: {0}\nROS path [0]=/x\033[0m\n"
    (end,) = ends_of(tmp_path, refused.format("ekf"))
    assert (end.node, end.describe()) == ("ekf/ekf_node", "cannot be started: there is no package ekf")
    assert not end.is_for_people
    (end,) = ends_of(tmp_path, refused.format("joy"))
    assert end.is_for_people


@pytest.mark.parametrize(
    ("command", "is_for_people"),
    [
        ("/usr/lib/rviz/rviz -d a.rviz", True),
        ("/opt/ros/noetic/lib/rqt_reconfigure/rqt_reconfigure", True),
        ("/ws/src/rviz/scripts/planner.py", False),
        ("bash -c 'sleep 1; /usr/lib/rviz/rviz'", False),
    ],
)
def test_who_only_shows_something_is_told_by_its_package(tmp_path, command, is_for_people):
    (end,) = ends_of(tmp_path, f"[robot1/view-7] process has died [pid 47, exit code -6, cmd {command}].\n")
    assert (end.node, end.exit_code, end.is_for_people) == ("robot1/view", -6, is_for_people)


def test_words_of_nodes_are_no_ends(tmp_path):
    assert ends_of(tmp_path, "[ERROR] [1.0] [/robot1/x]: my process has died\n", "process has died\n") == []


def test_participant_that_the_simulator_missed_is_the_culprit(tmp_path):
    simulator = {"participant": "robot1/move_base", "error": "robot1/move_base did not answer period 200"}
    ends = [NodeEnd("sim2d", 3)]
    failure = failure_of(plan(tmp_path), signs(ends, exit_code=1, simulator=simulator))
    assert (failure.culprit, failure.reason) == (
        "robot1/move_base",
        "robot1/move_base did not answer period 200",
    )


def test_its_own_end_says_more_than_the_simulator(tmp_path):
    simulator = {"participant": "robot1/move_base", "error": "silent"}
    ends = [NodeEnd("robot1/move_base", -9), NodeEnd("sim2d", 3)]
    assert failure_of(plan(tmp_path), signs(ends, simulator=simulator)).reason == "was killed by signal 9"


def test_simulator_is_the_culprit_of_its_own_error(tmp_path):
    failure = failure_of(plan(tmp_path), signs([NodeEnd("sim2d", 2)], simulator={"error": "no such world"}))
    assert (failure.culprit, failure.reason) == ("sim2d", "no such world")


def test_first_node_that_ended_is_the_culprit(tmp_path):
    ends = [NodeEnd("map_server", 255), NodeEnd("robot1/move_base", 1)]
    failure = failure_of(plan(tmp_path), signs(ends))
    assert (failure.culprit, failure.reason) == ("map_server", "ended with exit code 255")


def test_race_manager_that_lost_its_planner_names_the_planner(tmp_path):
    lost = [RaceUpdate("robot1", 5.0, RaceState.LOST, 1, "goal 2 of 3 lost: the action server is gone")]
    failure = failure_of(plan(tmp_path), signs(lost=lost))
    assert failure.culprit == "robot1/move_base"
    assert failure.reason == "goal 2 of 3 lost: the action server is gone"


def test_roslaunch_that_fails_is_quoted(tmp_path):
    made = plan(tmp_path)
    said = ["... logging to x", "\033[31mResource not found: a\033[0m", "ROS path [0]=/b", "The traceback"]
    made.launch_log.write_text("\n".join(said), encoding="utf-8")
    failure = failure_of(made, signs(exit_code=1))
    reason = "ended with exit code 1: Resource not found: a"
    assert (failure.culprit, failure.reason) == ("roslaunch", reason)
    assert failure.log_lines[1] == "Resource not found: a"


def test_last_words_come_from_the_nodes_log(tmp_path):
    made = plan(tmp_path)
    (made.log_folder / "robot1-move_base-5.log").write_text("", encoding="utf-8")
    (made.log_folder / "robot1-move_base-5-stdout.log").write_text("one\ntwo\n", encoding="utf-8")
    end = NodeEnd("robot1/move_base", -9, f"{made.log_folder}/robot1-move_base-5*.log")
    failure = failure_of(made, signs([end]))
    assert failure.log_file == str(made.log_folder / "robot1-move_base-5-stdout.log")
    assert failure.log_lines == ("one", "two")


def test_last_words_without_an_own_log_come_from_the_common_one(tmp_path):
    made = plan(tmp_path)
    made.launch_log.write_text(
        "[WARN] [1] [/sim2d]: a\n[WARN] [1] [/robot1/move_base]: b\n", encoding="utf-8"
    )
    failure = failure_of(made, signs([NodeEnd("robot1/move_base", 1)]))
    assert failure.log_lines == ("[WARN] [1] [/robot1/move_base]: b",)


TRACEBACK = """\
Traceback (most recent call last):
  File "/ws/gap.py", line 3, in answer
    ranges[9]
IndexError: no 9
"""


def test_exception_that_nobody_caught_is_in_the_reason(tmp_path):
    made = plan(tmp_path)
    died = DIED.replace("robot1/move_base", "robot1/gap").replace("-9", "1")
    made.launch_log.write_text(TRACEBACK + died, encoding="utf-8")
    (end,) = ends_of(tmp_path, TRACEBACK, died)
    failure = failure_of(made, signs([end]))
    assert failure.reason == "ended with exit code 1; it raised IndexError: no 9"
    assert failure.log_lines == tuple(TRACEBACK.splitlines())


def test_what_others_say_amid_a_traceback_is_no_part_of_it(tmp_path):
    made = plan(tmp_path)
    died = DIED.replace("robot1/move_base", "robot1/gap").replace("-9", "1")
    others = "[INFO] [1.0] [/map_server]: Read a map\nprocess[record-9]: started with pid [4]\n"
    amid = TRACEBACK.replace("IndexError", f"{others}IndexError")
    made.launch_log.write_text(amid + died, encoding="utf-8")
    failure = failure_of(made, signs([*ends_of(tmp_path, amid, died)]))
    assert failure.reason == "ended with exit code 1; it raised IndexError: no 9"
    assert failure.log_lines == tuple(TRACEBACK.splitlines())


def test_exception_in_a_callback_is_in_the_reason_of_who_fell_silent(tmp_path):
    made = plan(tmp_path)
    (made.log_folder / "latest").mkdir()
    said = "[rosout][ERROR] 1: bad callback\n" + TRACEBACK
    (made.log_folder / "latest" / "robot1-gap-5.log").write_text(said, encoding="utf-8")
    failure = failure_of_driver(made, "robot1", ["robot1/gap"], "has sent no command")
    assert failure.reason == "has sent no command; it raised IndexError: no 9"


def move_base_with_log(made, text, exit_code):
    (made.log_folder / "robot1-move_base-5.log").write_text(text, encoding="utf-8")
    return NodeEnd("robot1/move_base", exit_code, f"{made.log_folder}/robot1-move_base-5*.log")


def test_who_was_killed_raised_nothing(tmp_path):
    made = plan(tmp_path)
    end = move_base_with_log(made, TRACEBACK, -9)
    assert failure_of(made, signs([end])).reason == "was killed by signal 9"


def test_who_only_chattered_is_quoted_with_nothing(tmp_path):
    made = plan(tmp_path)
    made.launch_log.write_text("of others\n", encoding="utf-8")
    end = move_base_with_log(made, "[rospy.init][INFO] 1: ready\n", 0)
    assert failure_of(made, signs([end])).log_lines == ()
