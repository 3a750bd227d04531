"""What is understood of the output of `ros2 launch`, as that of ROS 2 Humble and Jazzy is."""

import shlex

from f1tenth_judge.drivers.ros2.launch_output import dead_processes, output_of_raiser

LAUNCH = ["[INFO] [launch]: Default logging verbosity is set to INFO", "[INFO] [gap-1]: process started"]
RAISED = [
    "Traceback (most recent call last):",
    '  File "/ws/install/gap/lib/python3.10/site-packages/gap/node.py", line 7, in hear',
    "    scan.no_such_field",
    "AttributeError: 'LaserScan' object has no attribute 'no_such_field'",
]
DIED = "[ERROR] [gap-1]: process has died [pid 7, exit code 1, cmd '/ws/install/gap/lib/gap/gap --ros-args']."


def launched(lines, name="gap-1"):
    return [f"[{name}] {line}" for line in lines]


def test_output_is_that_of_the_process_that_raised():
    others = launched(["[INFO] [1796039831.2] [map]: ready"], "map_loader.py-2")
    mixed = [line for pair in zip(launched(RAISED), 4 * others) for line in pair]
    assert output_of_raiser([*LAUNCH, *mixed, "[gap-1]", DIED]) == [*LAUNCH, *RAISED, DIED]


def test_output_without_an_exception_is_left_as_it_is():
    lines = [*LAUNCH, *launched(["[INFO] [1796039831.2] [gap]: waiting for a joystick"])]
    assert output_of_raiser(lines) == lines


def test_processes_that_died_are_named_and_those_that_finished_are_not():
    killed = "[ERROR] [map-2]: process has died [pid 8, exit code -9, cmd 'map']."
    finished = "[INFO] [once-3]: process has finished cleanly [pid 9]"
    assert dead_processes([DIED, finished, killed]) == [
        "gap-1 died with exit code 1",
        "map-2 died with exit code -9",
    ]


def test_launch_that_ends_as_its_node_has_died_is_told_by_the_node(race):
    said = shlex.join([*launched(RAISED), DIED])
    result = race(f"printf '%s\\n' {said}")
    reason = f"ended with exit code 0; gap-1 died with exit code 1; it raised {RAISED[-1]}"
    assert reason in result["reason"]
    assert result["culprit"]["log_lines"] == [*RAISED, DIED]


def test_all_that_the_nodes_say_is_kept_with_the_run(race, tmp_path):
    race('echo "$OVERRIDE_LAUNCH_PROCESS_OUTPUT $ROS_LOG_DIR"')
    assert (tmp_path / "log" / "robot1.log").read_text() == f"screen {tmp_path}/log\n"
