"""Every mistake in a scenario file is answered with its place and what is allowed there."""

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.source import read_scenario
from f1tenth_judge.scenario.car import Pose
from f1tenth_judge.scenario.scenario import Verdict
from scenario_samples import SCENARIO_TEXT

TOP_KEYS = (
    "description, world, cars, limits, expected, seed, tags, culprit, reason, course, start_line, laps,"
    " time_to_start, lockstep, pinned, real_time_factor, localization, boxes, criteria, faults, interventions"
)
CAR_KEYS = (
    "name, start, ahead, driver, goals, laps, line, speed_max, acceleration_max, description,"
    " description_arguments, commands, mu, actuation_latency, model, dropped_beams, input_faults"
)


def write(tmp_path, text):
    path = tmp_path / "sample.yaml"
    path.write_text(text, encoding="utf-8")
    return path


def message(tmp_path, text):
    path = write(tmp_path, text)
    with pytest.raises(ScenarioError) as caught:
        read_scenario(path)
    return str(caught.value).replace(str(path), "FILE")


def changed(old, new):
    assert old in SCENARIO_TEXT
    return SCENARIO_TEXT.replace(old, new)


def test_minimal_file_gets_the_defaults(tmp_path):
    scenario = read_scenario(write(tmp_path, SCENARIO_TEXT))
    assert scenario.expected is Verdict.SUCCESS
    assert scenario.cars[0].start is None
    assert scenario.cars[0].driver.name == "race"
    assert (scenario.laps, scenario.lockstep, scenario.limits.wall) == (1, True, 300.0)


def test_every_key_is_read(tmp_path):
    text = changed(
        "    goals: circuit1\n",
        "    start: {x: 1, y: 2.5, yaw: -1.0}\n    driver: commands\n"
        "    commands: [{at: 0, speed: 1}, {at: 2.0, speed: 0, steering_angle: 0.1}]\n",
    )
    text += (
        "laps: 3\ntime_to_start: 0\nlockstep: false\nreal_time_factor: 2\n"
        "criteria: {goal_tolerance: 0.2, goal_yaw_tolerance: 1.0, minimum_clearance: 0.1}\n"
        "faults: [{kill: robot1/move_base, at: 5}]\n"
    )
    scenario = read_scenario(write(tmp_path, text))
    assert scenario.cars[0].start == Pose(1.0, 2.5, -1.0)
    assert scenario.cars[0].commands[1].steering_angle == 0.1
    assert scenario.faults[0].kill == "robot1/move_base"
    assert scenario.criteria.minimum_clearance == 0.1
    assert (scenario.laps, scenario.lockstep, scenario.real_time_factor) == (3, False, 2.0)


def test_driver_may_be_a_launch_file(tmp_path):
    text = changed(
        "    goals: circuit1",
        "    driver: {launch: my.launch, interface: f1tenth, arguments: {speed: 4.0, brave: true}}\n"
        "    laps: 3",
    )
    car = read_scenario(write(tmp_path, text)).cars[0]
    assert (car.driver.launch, car.driver.interface.value, car.laps) == ("my.launch", "f1tenth", 3)
    assert car.driver.arguments == {"speed": "4.0", "brave": "true"}


ANSWERS = {
    "unknown key": ("seed: 1", "seed: 1\ncolour: red", f"FILE:10: unknown key 'colour'; allowed: {TOP_KEYS}"),
    "unknown key inside": (
        "    goals: circuit1",
        "    goals: circuit1\n    colour: red",
        f"FILE:6: unknown key 'colour' in cars[0]; allowed: {CAR_KEYS}",
    ),
    "missing key": ("seed: 1\n", "", f"FILE:1: missing key 'seed'; allowed: {TOP_KEYS}"),
    "missing keys": (
        "expected: success\nseed: 1\n",
        "",
        f"FILE:1: missing keys 'expected', 'seed'; allowed: {TOP_KEYS}",
    ),
    "missing key inside": (
        "timeout: 10.0",
        "wall: 10.0",
        "FILE:7: missing key 'timeout' in limits; allowed: timeout, answer, load, silence, wall",
    ),
    "twice": ("seed: 1", "seed: 1\nseed: 2", "FILE:10: key 'seed' is given twice, first in line 9"),
    "no number": ("10.0", "soon", "FILE:7: limits.timeout must be a number (s), found 'soon'"),
    "nan": ("10.0", ".nan", "FILE:7: limits.timeout must be a number (s), found '.nan'"),
    "list instead of number": ("10.0", "[1]", "FILE:7: limits.timeout must be a number (s), found a list"),
    "foreign tag": ("10.0", "!degrees 10", "FILE:7: limits.timeout must be a number (s), found '10'"),
    "not whole": ("seed: 1", "seed: 1.5", "FILE:9: seed must be a whole number, found '1.5'"),
    "truth for a number": ("seed: 1", "seed: true", "FILE:9: seed must be a whole number, found 'true'"),
    "number for a text": ("world: circuit1", "world: 1", "FILE:2: world must be a text, found '1'"),
    "nothing": ("world: circuit1", "world:", "FILE:2: world must be a text, found nothing"),
    "too small": ("10.0", "0", "FILE:7: limits.timeout is 0, must be above 0 s"),
    "seed beyond what a ROS parameter holds": (
        "seed: 1",
        "seed: 2147483648",
        "FILE:9: seed is 2147483648, must be at least 0 and at most 2147483647",
    ),
    "negative seed": ("seed: 1", "seed: -1", "FILE:9: seed is -1, must be at least 0 and at most 2147483647"),
    "no truth": ("seed: 1", "seed: 1\nlockstep: 1", "FILE:10: lockstep must be true or false, found '1'"),
    "verdict": (
        "expected: success",
        "expected: sucess",
        "FILE:8: expected is 'sucess'; allowed: success, collision, timeout, aborted, disqualified, error",
    ),
    "no mapping": (
        "limits:\n  timeout: 10.0",
        "limits: 10",
        "FILE:6: limits must be a mapping with the keys timeout, answer, load, silence, wall, found '10'",
    ),
    "no list": (
        "cars:\n  - name: robot1\n    goals: circuit1",
        "cars: robot1",
        "FILE:3: cars must be a list, found 'robot1'",
    ),
    "no car": (
        "\n  - name: robot1\n    goals: circuit1",
        " []",
        "FILE:3: cars is empty; at least one car is needed",
    ),
    "car twice": (
        "    goals: circuit1",
        "    goals: circuit1\n  - {name: robot1, goals: circuit1}",
        "FILE:4: cars has a name twice: robot1, robot1",
    ),
    "car's name": (
        "name: robot1",
        "name: robot-1",
        "FILE:4: cars[0].name is 'robot-1', must be a letter followed by letters, digits and underscores",
    ),
    "two starts": (
        "name: robot1",
        "name: robot1\n    start: {x: 1.0, y: 0.0}\n    ahead: 2.5",
        "FILE:6: cars[0].ahead is given beside 'start'; the car can be put in one place only",
    ),
    "car named like the simulator": (
        "name: robot1",
        "name: sim2d",
        "FILE:4: cars[0].name is 'sim2d', must be none of gazebo, sim2d",
    ),
    "unknown driver": (
        "    goals: circuit1",
        "    driver: racer",
        "FILE:5: cars[0].driver must be race, pursuit, commands, gap_follower, or a mapping with the keys"
        " launch, interface, arguments, ros2, python, found 'racer'",
    ),
    "driver without a launch file": (
        "    goals: circuit1",
        "    driver: {interface: native}",
        "FILE:5: cars[0].driver.launch is missing; exactly one of launch, ros2, python is needed",
    ),
    "driver of two kinds": (
        "    goals: circuit1",
        "    driver: {launch: my.launch, ros2: ros2 launch my.launch}",
        "FILE:5: cars[0].driver.launch is given beside 'ros2'; exactly one of launch, ros2, python is needed",
    ),
    "python driver without a class": (
        "    goals: circuit1",
        "    driver: {python: my.py}",
        "FILE:5: cars[0].driver.python is 'my.py', must be FILE.py:CLASS",
    ),
    "interface of a ROS 2 driver": (
        "    goals: circuit1",
        "    driver: {ros2: my_planner, interface: f1tenth}",
        "FILE:5: cars[0].driver.interface is 'f1tenth', may be f1tenth_gym_ros for 'ros2'",
    ),
    "unknown interface": (
        "    goals: circuit1",
        "    driver: {launch: my.launch, interface: ros2}",
        "FILE:5: cars[0].driver.interface is 'ros2'; allowed: native, f1tenth, f1tenth_gym_ros",
    ),
    "arguments that are none": (
        "    goals: circuit1",
        "    driver: {launch: my.launch, arguments: [4.0]}",
        "FILE:5: cars[0].driver.arguments must be a mapping of names to values, found a list",
    ),
    "list for an argument": (
        "    goals: circuit1",
        "    driver: {launch: my.launch, arguments: {speed: [4.0]}}",
        "FILE:5: cars[0].driver.arguments.speed must be a single value, found a list",
    ),
    "order of commands": (
        "    goals: circuit1",
        "    driver: commands\n    commands: [{at: 1, speed: 1}, {at: 1, speed: 2}]",
        "FILE:6: cars[0].commands must be in order of time ('at'), each time once",
    ),
    "two bounds": (
        "    goals: circuit1",
        "    driver: commands\n    commands: [{at: 1, speed: 21}]",
        "FILE:6: cars[0].commands[0].speed is 21, must be at least -5 m/s and at most 20 m/s",
    ),
    "time that waits for nobody": (
        "seed: 1",
        "seed: 1\nlockstep: false\nreal_time_factor: 0",
        "FILE:11: real_time_factor is 0, must be above 0",
    ),
    "no culprit": (
        "expected: success",
        "expected: error",
        "FILE:1: culprit is missing; an expected error must say whose it is",
    ),
    "limit of the reference that is not given": (
        "seed: 1",
        "seed: 1\ncriteria: {lap_time: 8, of_reference: [lap_time, standstill]}",
        "FILE:10: criteria.of_reference has 'standstill', must be limits that are given: lap_time",
    ),
    "culprit of no error": (
        "seed: 1",
        "seed: 1\nculprit: robot1/move_base",
        "FILE:10: culprit is for the expected verdict 'error' only",
    ),
    "fault of an unknown input": (
        "    goals: circuit1",
        "    goals: circuit1\n    input_faults: [{inputs: [imu], at: 1, until: 2}]",
        "FILE:6: cars[0].input_faults[0].inputs[0] is 'imu'; allowed: scan, odom, tf",
    ),
    "fault of no input": (
        "    goals: circuit1",
        "    goals: circuit1\n    input_faults: [{inputs: [], at: 1, until: 2}]",
        "FILE:6: cars[0].input_faults[0].inputs is empty; allowed: scan, odom, tf",
    ),
    "input fault that ends before it begins": (
        "    goals: circuit1",
        "    goals: circuit1\n    input_faults: [{inputs: [tf], at: 2, until: 2}]",
        "FILE:6: cars[0].input_faults[0].until is 2, must be after 'at' (2 s)",
    ),
    "input faults at once": (
        "    goals: circuit1",
        "    goals: circuit1\n    input_faults:\n      - {inputs: [scan, odom], at: 3, until: 5}\n"
        "      - {inputs: [odom], at: 1, until: 4, delay: 0.1}",
        "FILE:7: cars[0].input_faults overlap for 'odom'",
    ),
    "input fault of a scan that loses beams": (
        "    goals: circuit1",
        "    goals: circuit1\n    dropped_beams: 0.1\n    input_faults: [{inputs: [scan], at: 1, until: 2}]",
        "FILE:7: cars[0].input_faults cannot concern a scan with 'dropped_beams'",
    ),
    "late input fault": (
        "    goals: circuit1",
        "    goals: circuit1\n    input_faults: [{inputs: [scan], at: 11, until: 12}]",
        "FILE:4: cars has an input fault after limits.timeout (10 s)",
    ),
    "push of what stands fast": (
        "seed: 1",
        "seed: 1\nboxes: [{name: box, x: 1, y: 1, pushes: [{at: 1, speed: 1}]}]",
        "FILE:10: boxes[0].pushes is for a box that is movable",
    ),
    "late push": (
        "seed: 1",
        "seed: 1\nboxes: [{name: box, x: 1, y: 1, movable: true, pushes: [{at: 11, speed: 1}]}]",
        "FILE:10: boxes has a push after limits.timeout (10 s)",
    ),
    "box like a car": (
        "seed: 1",
        "seed: 1\nboxes: [{name: robot1, x: 1, y: 1}]",
        "FILE:10: boxes has a name twice, or that of a car: robot1",
    ),
    "degrees": (
        "    goals: circuit1",
        "    goals: circuit1\n    start: {x: 0, y: 0, yaw: 180}",
        "FILE:6: cars[0].start.yaw is 180, must be at least -6.284 rad and at most 6.284 rad",
    ),
    "name that no file has": (
        "world: circuit1",
        'world: "a\\0b"',
        "FILE:2: world must be a text without control characters, found 'a\\x00b'",
    ),
    "name of two lines": (
        "name: robot1",
        'name: "a\\nb"',
        "FILE:4: cars[0].name is 'a\\nb', must be a letter followed by letters, digits and underscores",
    ),
    "late fault": (
        "seed: 1",
        "seed: 1\nfaults: [{kill: robot1/move_base, at: 11}]",
        "FILE:10: faults has a time after limits.timeout (10 s)",
    ),
}


@pytest.mark.parametrize("case", ANSWERS)
def test_mistake_is_answered(tmp_path, case):
    old, new, answer = ANSWERS[case]
    assert message(tmp_path, changed(old, new)) == answer


def test_list_at_the_top_is_refused(tmp_path):
    assert message(tmp_path, "- 1\n") == "FILE:1: must be a mapping of keys to values"


def test_empty_file_is_refused(tmp_path):
    assert message(tmp_path, "") == "FILE:1: must be a mapping of keys to values"


def test_broken_yaml_is_refused_with_its_line(tmp_path):
    assert message(tmp_path, "a: 1\nb: [1\nc: 2\n") == "FILE:3: not YAML: expected ',' or ']', but got ':'"


def test_control_characters_are_refused(tmp_path):
    assert message(tmp_path, "a: \x01\n").startswith("FILE: not YAML: ")


def test_file_that_is_not_there_is_named(tmp_path):
    with pytest.raises(ScenarioError, match="nowhere.yaml: cannot be read: No such file or directory"):
        read_scenario(tmp_path / "nowhere.yaml")
