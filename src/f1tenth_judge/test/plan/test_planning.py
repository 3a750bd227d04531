"""What a scenario names is found, and fits together."""

import math

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.plan import participants
from f1tenth_judge.plan.hand_off import driver_arguments
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.scenario.car import Pose
from scenario_samples import SCENARIO_TEXT

CAR = "    goals: circuit1\n"
# A square of 10 m whose centreline begins in the middle of its left side and leads upwards.
CENTRELINE = "# x_m, y_m, w_tr_right_m, w_tr_left_m\n0,5,1.0,0.6\n0,10,1,1\n10,10,1,1\n10,0,1,1\n0,0,1,1\n"
RACELINE = "# a\n# b\n# c\n" + "".join(f"{i}; {i}; {i * i}; 0; 0; 2; 0\n" for i in range(4))


@pytest.fixture
def planned(tmp_path):
    """Plans the sample scenario, its car's lines replaced by others."""

    def plan(car=CAR, more="", world="circuit1"):
        path = tmp_path / "sample.yaml"
        text = SCENARIO_TEXT.replace(CAR, car).replace("world: circuit1", f"world: {world}")
        path.write_text(text + more, encoding="utf-8")
        return make_plan(str(path))

    return plan


@pytest.fixture
def launch(tmp_path):
    """Writes a driver's launch file with some arguments."""

    def write(content):
        (tmp_path / "my.launch").write_text(f"<launch>{content}</launch>", encoding="utf-8")
        return "    driver: {launch: my.launch}\n    laps: 2\n"

    return write


@pytest.fixture
def track(tmp_path):
    """A map of the F1TENTH community with its centreline; of the map only the name matters here."""
    (tmp_path / "T_map.yaml").write_text("image: T_map.png\n", encoding="utf-8")
    (tmp_path / "T_centerline.csv").write_text(CENTRELINE, encoding="utf-8")
    return "T_map.yaml"


@pytest.mark.parametrize(
    ("car", "problem"),
    [
        ("    driver: commands\n", "robot1: the driver 'commands' needs the key 'commands'"),
        (
            CAR + "    commands: [{at: 0, speed: 1}]\n",
            "robot1: 'commands' is nothing that the driver 'race' takes",
        ),
        (
            "    driver: pursuit\n    acceleration_max: 1\n",
            "robot1: 'acceleration_max' is nothing that the driver 'pursuit' takes",
        ),
        ("    driver: {launch: none.launch}\n", "no such file: {folder}/none.launch"),
        ("    driver: {launch: package://nobody/x.launch}\n", "package nobody not found"),
        ("    driver: {launch: package://f1tenth_scenarios/x.launch}\n", "no such file: "),
        (
            "    driver: pursuit\n",
            "'expected: success' needs a car with 'goals' or 'laps'; 'laps' outside of 'cars' repeats goals",
        ),
    ],
)
def test_what_does_not_fit_together_is_answered(planned, tmp_path, car, problem):
    with pytest.raises(ScenarioError) as caught:
        planned(car)
    assert str(caught.value).startswith(
        f"{tmp_path}/sample.yaml: {problem.replace('{folder}', str(tmp_path))}"
    )


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ('<arg name="speed"/>', "robot1: the driver 'my.launch' needs a value for its argument 'speed'"),
        ("<node>", "{folder}/my.launch: not a launch file: mismatched tag"),
    ],
)
def test_launch_file_that_cannot_be_a_driver_is_answered(planned, launch, tmp_path, content, problem):
    with pytest.raises(ScenarioError) as caught:
        planned(launch(content))
    assert problem.replace("{folder}", str(tmp_path)) in str(caught.value)


def test_driver_that_needs_goals_gets_those_of_the_circuit(planned, track):
    assert planned("").goals_file("robot1").name == "circuit1.txt"


def test_driver_that_needs_goals_gets_some_along_the_road_of_a_track(planned, track):
    plan = planned("", world=track)
    goals = plan.cars["robot1"].goals
    assert plan.goals_file("robot1") == plan.log_folder / "robot1_goals.txt"
    assert [(goal.x, goal.y) for goal in (goals[0], goals[-1])] == [(0.0, pytest.approx(9.0)), (0.0, 5.0)]
    assert goals[-1].yaw == pytest.approx(math.pi / 2)


def test_driver_that_needs_goals_is_not_left_without(planned, tmp_path):
    (tmp_path / "empty.world").write_text("<sdf version='1.6'><world name='w'/></sdf>", encoding="utf-8")
    with pytest.raises(ScenarioError, match="robot1: the driver 'race' needs the key 'goals'"):
        planned("", world="empty.world")


def test_argument_that_a_driver_does_not_have_is_answered(planned, launch, tmp_path):
    launch('<arg name="speed" default="1"/><arg name="fixed" value="2"/>')
    with pytest.raises(ScenarioError, match="my.launch has no argument 'fixed'; it has: speed"):
        planned("    driver: {launch: my.launch, arguments: {fixed: 3}}\n    laps: 2\n")


def test_driver_gets_what_it_declares_and_the_scenario_has(planned, launch):
    plan = planned(
        launch(
            '<arg name="car_name"/><arg name="laps"/><arg name="x" default="1"/>'
            '<arg name="goals_file" default="mine"/>'
        )
    )
    (car,) = plan.scenario.cars
    assert driver_arguments(plan, car) == {"car_name": "robot1", "laps": 3}


def test_arguments_of_the_scenario_count_more(planned, launch):
    launch('<arg name="laps"/><arg name="speed" default="1"/>')
    plan = planned("    driver: {launch: my.launch, arguments: {laps: 7, speed: 4.0}}\n    laps: 2\n")
    (car,) = plan.scenario.cars
    assert driver_arguments(plan, car) == {"laps": "7", "speed": "4.0"}


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ("lines/c.csv", "{folder}/lines/c.csv"),
        ("{folder}/lines/c.csv", "{folder}/lines/c.csv"),
        ("package://f1tenth_gazebo/goals/circuit1.txt", "{gazebo}/goals/circuit1.txt"),
        ("lines/none.csv", "lines/none.csv"),
        ("lines", "lines"),
        ("", ""),
        ("x" * 300, "x" * 300),
    ],
)
def test_argument_that_names_a_file_is_told_as_its_path(planned, launch, tmp_path, given, told):
    folders = {"folder": tmp_path, "gazebo": lookup.package_path("f1tenth_gazebo")}
    (tmp_path / "lines").mkdir()
    (tmp_path / "lines" / "c.csv").touch()
    launch('<arg name="waypoints"/>')
    argument = f'"{given.format(**folders)}"'
    plan = planned(f"    driver: {{launch: my.launch, arguments: {{waypoints: {argument}}}}}\n    laps: 2\n")
    (car,) = plan.scenario.cars
    assert driver_arguments(plan, car) == {"waypoints": told.format(**folders)}


@pytest.mark.parametrize(
    ("given", "problem"),
    [
        (
            "$(find my_stack)/c.csv",
            "'$(find my_stack)/c.csv': roslaunch would put something else in the place of '$(';"
            " use package://PACKAGE/PATH for a file of a package",
        ),
        ("package://f1tenth_gazebo/none.csv", "no such file: {gazebo}/none.csv"),
        ("package://nobody/c.csv", "package nobody not found"),
    ],
)
def test_argument_that_cannot_be_told_is_answered(planned, launch, tmp_path, given, problem):
    launch('<arg name="waypoints"/>')
    with pytest.raises(ScenarioError) as caught:
        planned(f"    driver: {{launch: my.launch, arguments: {{waypoints: {given}}}}}\n    laps: 2\n")
    problem = problem.format(gazebo=lookup.package_path("f1tenth_gazebo"))
    assert str(caught.value).startswith(f"{tmp_path}/sample.yaml: robot1: argument 'waypoints': {problem}")


def test_without_a_countdown_no_start_is_too_early(planned):
    commands = "    driver: commands\n    commands: [{at: 0, speed: 1}]\n    laps: 1\n"
    assert not planned(commands).tasks["robot1"].obeys_start
    both = planned(CAR + "  - name: robot2\n" + commands)
    assert both.has_countdown
    assert all(task.obeys_start for task in both.tasks.values())


def test_cars_start_at_the_origin_of_a_circuit(planned):
    assert planned().cars["robot1"].start == Pose(0.0, 0.0, 0.0)


def test_cars_start_on_the_centreline_of_a_track_with_its_heading(planned, track):
    plan = planned("    driver: pursuit\n    laps: 1\n", world=track)
    assert plan.cars["robot1"].start == Pose(0.0, 5.0, pytest.approx(math.pi / 2))


def test_lap_line_lies_across_the_road_at_the_start(planned, track):
    line = planned("    driver: pursuit\n    laps: 1\n", world=track).tasks["robot1"].line
    assert (line.x, line.y) == (pytest.approx(0.2), pytest.approx(5.0))
    assert (line.yaw, line.width) == (pytest.approx(math.pi / 2), pytest.approx(1.6))


def test_start_line_of_the_scenario_counts_more(planned):
    plan = planned("    driver: pursuit\n    laps: 1\n", more="start_line: {x: 1, width: 2}\n")
    assert (plan.tasks["robot1"].line.x, plan.tasks["robot1"].line.width) == (1.0, 2.0)


def test_pursuit_follows_the_raceline_beside_the_map(planned, track, tmp_path):
    car = "    driver: pursuit\n    laps: 1\n"
    assert planned(car, world=track).cars["robot1"].line == tmp_path / "T_centerline.csv"
    (tmp_path / "T_raceline.csv").write_text(RACELINE, encoding="utf-8")
    assert planned(car, world=track).cars["robot1"].line == tmp_path / "T_raceline.csv"


def test_pursuit_follows_the_middle_of_a_circuit(planned):
    assert planned("    driver: pursuit\n    laps: 1\n").cars["robot1"].line.name == "circuit1.yaml"


def test_planner_of_others_is_told_the_middle_of_a_circuit_as_a_table(planned, launch):
    plan = planned(launch('<arg name="line"/><arg name="road"/>'))
    (car,) = plan.scenario.cars
    middle = lookup.package_path("f1tenth_gazebo") / "worlds" / "circuit1_centerline.csv"
    assert driver_arguments(plan, car) == {"line": middle, "road": middle}


def test_laps_need_a_line(planned, tmp_path):
    (tmp_path / "empty.world").write_text("<sdf version='1.6'><world name='w'/></sdf>", encoding="utf-8")
    with pytest.raises(ScenarioError, match="'laps' of a car needs a 'start_line' or a 'course'"):
        planned("    driver: commands\n    commands: [{at: 0, speed: 1}]\n    laps: 1\n", world="empty.world")


def test_a_car_can_be_put_some_way_along_any_road(planned, track):
    ahead = "    driver: pursuit\n    laps: 1\n    ahead: 2.5\n"
    on_circuit = planned(ahead).cars["robot1"].start
    assert (on_circuit.x, on_circuit.y, on_circuit.yaw) == pytest.approx((2.5, 0.0, 0.0))
    starts = [planned(car, world=track).cars["robot1"].start for car in (ahead.replace("2.5", "0"), ahead)]
    start, on_track = starts
    assert (start.x, start.y, start.yaw) == pytest.approx((0.0, 5.0, math.pi / 2))
    assert (on_track.x, on_track.y, on_track.yaw) == pytest.approx((0.0, 7.5, math.pi / 2))


def test_a_car_can_be_put_ahead_on_a_road_only(planned, tmp_path):
    (tmp_path / "empty.world").write_text("<sdf version='1.6'><world name='w'/></sdf>", encoding="utf-8")
    car = "    driver: commands\n    commands: [{at: 0, speed: 1}]\n    ahead: 1.0\n"
    lacks = "'ahead' of a car needs a road: .*empty.world is no circuit, and there is no empty_centerline.csv"
    tools = f"make_map {tmp_path}/empty.world -o {tmp_path}/empty` and `rosrun f1tenth_gazebo make_centerline"
    with pytest.raises(
        ScenarioError, match=f"{lacks} beside it; make it with `rosrun f1tenth_gazebo {tools} "
    ):
        planned(car, world="empty.world")
    (tmp_path / "empty.yaml").touch()
    with pytest.raises(
        ScenarioError, match=f"{lacks} beside it; make it with `rosrun f1tenth_gazebo make_centerline "
    ):
        planned(car, world="empty.world")


@pytest.fixture
def originals(monkeypatch):
    """Installs the originals of some stand-ins, as far as a plan can tell."""

    def install(*names):
        monkeypatch.setattr(participants, "is_original", lambda package: package in names)

    return install


@pytest.mark.parametrize(
    ("names", "note"),
    [
        (["move_base"], "run in real time, as the original of move_base knows no lockstep"),
        (["amcl", "move_base"], "run in real time, as the original of amcl and move_base knows no lockstep"),
        (["map_server"], ""),
    ],
)
def test_with_an_original_that_knows_no_lockstep_the_run_is_paced(planned, originals, names, note):
    originals(*names)
    plan = planned(more="localization: amcl\n")
    assert plan.note == note
    assert plan.scenario.lockstep == (not note)


def test_an_original_that_does_not_take_part_changes_nothing(planned, originals):
    originals("amcl", "move_base")
    assert planned("    driver: pursuit\n    laps: 1\n").scenario.lockstep
