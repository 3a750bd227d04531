"""What is quoted of a node that failed: no chatter, and of a traceback what the planner's author can mend."""

from f1tenth_judge.run.log_excerpt import exception_in, last_lines, quoted

CHATTER = [
    "[rospy.init][INFO] 2026-01-01 00:00:00,000: registered with master",
    "[xmlrpc][INFO] 2026-01-01 00:00:00,000: xml rpc node: starting XML-RPC server",
]
HEAD = "Traceback (most recent call last):"
EXCEPTION = "IndexError: list index out of range"


def frame(path, code="answer(scan)"):
    return [f'  File "{path}", line 3, in f', f"    {code}"]


OWN = frame("/ws/src/my_stack/scripts/gap.py", "ranges[9999]")
ROSPY = frame("/usr/lib/python3/dist-packages/rospy/topics.py")
NUMPY = frame("/ws/.venv/lib/python3.11/site-packages/numpy/core.py")


def test_chatter_of_rospy_is_left_out():
    own = "[rosout][INFO] 2026-01-01 00:00:00,000: waiting for a joystick"
    assert quoted([*CHATTER, own, *CHATTER]) == [own]
    assert quoted(CHATTER) == []


def test_last_lines_are_quoted():
    assert quoted([str(number) for number in range(20)]) == [str(number) for number in range(10, 20)]


def test_traceback_is_quoted_by_the_last_frame_of_the_planner():
    lines = ["before", HEAD, *ROSPY, *OWN, *7 * NUMPY, EXCEPTION, "after"]
    assert quoted(lines) == ["before", HEAD, *OWN, EXCEPTION, "after"]


def test_a_script_that_cannot_be_parsed_tells_where():
    place = ['  File "/ws/src/my_stack/scripts/gap.py", line 3', "    def f(:", "          ^"]
    lines = ["before", *place, "SyntaxError: invalid syntax", "after"]
    assert exception_in(lines) == "SyntaxError: invalid syntax"
    assert quoted(lines) == ["before", *place, "SyntaxError: invalid syntax", "after"]


def test_package_in_a_workspace_of_ros_2_is_the_planners_own():
    script = frame("/ws/install/my_package/lib/my_package/planner", "sys.exit(load_entry_point(...)())")
    own = frame("/ws/install/my_package/lib/python3.10/site-packages/my_package/gap.py")
    assert quoted([HEAD, *script, *NUMPY, *own, *NUMPY, EXCEPTION]) == [HEAD, *own, EXCEPTION]


def test_traceback_is_quoted_however_much_is_said_later():
    later = [f"still here {number}" for number in range(20)]
    assert quoted([*later, HEAD, *OWN, EXCEPTION, *later]) == [HEAD, *OWN, EXCEPTION, *later[:6]]


def test_traceback_without_a_frame_of_the_planner_is_quoted_by_its_last():
    assert quoted([HEAD, *ROSPY, *NUMPY, EXCEPTION]) == [HEAD, *NUMPY, EXCEPTION]
    assert quoted([HEAD, EXCEPTION]) == [HEAD, EXCEPTION]


def test_traceback_whose_end_is_missing_is_quoted():
    assert quoted([HEAD, *OWN])[:2] == [HEAD, OWN[0]]
    assert quoted([HEAD]) == [HEAD]


def test_exception_is_what_the_last_traceback_ends_with():
    assert exception_in([HEAD, *OWN, "KeyError: 3", HEAD, *OWN, EXCEPTION, "after"]) == EXCEPTION
    for lines in (["no traceback"], [HEAD], [HEAD, *OWN], [HEAD, *OWN, "[INFO] of others"], []):
        assert exception_in(lines) == ""
    assert len(exception_in([HEAD, *OWN, "ValueError: " + "very " * 100])) <= 200


def test_last_lines_leave_out_empty_ones(tmp_path):
    path = tmp_path / "log"
    path.write_text("one\n\ntwo  \nthree\n\n", encoding="utf-8")
    assert last_lines(path, 2) == ["two", "three"]
    assert last_lines(tmp_path / "none", 2) == []
