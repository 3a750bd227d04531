"""Who is to blame for a set-up that broke, and what it said last."""

from f1tenth_judge.record.observations import RaceState, RaceUpdate
from f1tenth_scenarios.launch.launch_events import NodeEnd
from f1tenth_scenarios.run.diagnosis.culprit import Signs, failure_of, failure_of_driver
from scenario_samples import sample_plan, scenario


def plan(folder):
    made = sample_plan(folder, scenario())
    made.log_folder.mkdir()
    return made


def signs(ends=(), lost=(), exit_code=None, simulator=None):
    return Signs(ends, lost, exit_code, simulator or {})


def test_participant_that_the_simulator_missed_is_the_culprit(tmp_path):
    simulator = {"participant": "robot1/move_base", "error": "robot1/move_base did not answer period 200"}
    ends = [NodeEnd("sim2d", 3)]
    failure = failure_of(plan(tmp_path), signs(ends, exit_code=1, simulator=simulator))
    assert (failure.culprit, failure.reason) == (
        "robot1/move_base",
        "robot1/move_base did not answer period 200",
    )


def test_a_driver_that_its_proxy_waits_for_is_the_culprit(tmp_path):
    error = "lockstep: participant robot1/proxy_driver has not answered period 2 within 15 s"
    simulator = {"participant": "robot1/proxy_driver", "error": error}
    seen = Signs([NodeEnd("sim2d", 3)], (), 1, simulator, ("sim2d", "robot1/proxy_driver", "robot1/gap"))
    failure = failure_of(plan(tmp_path), seen)
    reason = "does not come to rest: lockstep: it has not answered period 2 within 15 s"
    assert (failure.culprit, failure.reason) == ("robot1/gap", reason)


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
    later = TRACEBACK.replace("no 9", "of another node")
    made.launch_log.write_text(TRACEBACK + later, encoding="utf-8")
    failure = failure_of(made, signs([NodeEnd("robot1/gap", 1, said=len(TRACEBACK))]))
    assert failure.reason == "ended with exit code 1; it raised IndexError: no 9"
    assert failure.log_lines == tuple(TRACEBACK.splitlines())


def test_what_others_say_amid_a_traceback_is_no_part_of_it(tmp_path):
    made = plan(tmp_path)
    others = "[INFO] [1.0] [/map_server]: Read a map\nprocess[record-9]: started with pid [4]\n"
    amid = TRACEBACK.replace("IndexError", f"{others}IndexError")
    made.launch_log.write_text(amid, encoding="utf-8")
    failure = failure_of(made, signs([NodeEnd("robot1/gap", 1)]))
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
