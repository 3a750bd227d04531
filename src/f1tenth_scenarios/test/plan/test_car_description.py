"""A car of the user's own: what a scenario reads of its description, hands on, and answers if it is wrong."""

import pytest
import roslaunch.config
from f1tenth_judge.batch.inputs import hash_inputs
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.planning import make_plan
from f1tenth_scenarios.launch.launch_file import write_launch_file
from scenario_samples import SCENARIO_TEXT

import f1tenth_sim2d

TRUCK = lookup.package_path(lookup.PACKAGE) / "test" / "workspace_of_others" / "urdf" / "truck.urdf.xacro"
OURS = "    description_arguments: {perfect_odometry: true}\n"
PLANNER = '<launch><node pkg="others_truck" type="planner.py" name="planner"/></launch>'
BROKEN = '<robot name="a" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="${foo}"/></robot>'
INCLUDING = (
    '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="truck.xacro"/></robot>'
)
FOREIGN = "    driver: {launch: planner.launch}\n    laps: 1\n"


@pytest.fixture
def planned(tmp_path):
    """Plans the sample scenario with a truck as its car."""
    (tmp_path / "truck.xacro").write_bytes(TRUCK.read_bytes())
    (tmp_path / "planner.launch").write_text(PLANNER, encoding="utf-8")

    def plan(car=OURS, description="truck.xacro", settings=()):
        path = tmp_path / "sample.yaml"
        text = SCENARIO_TEXT.replace("    goals: circuit1\n", f"    description: {description}\n{car}")
        path.write_text(text, encoding="utf-8")
        made = make_plan(str(path), tmp_path / "results", settings)
        made.log_folder.mkdir(parents=True, exist_ok=True)
        return made

    return plan


def loaded(plan):
    """What roslaunch makes of the run: parameters, and the topics that each node knows by another name."""
    write_launch_file(plan)
    config = roslaunch.config.load_config_default([str(plan.launch_file)], None)
    parameters = {name: each.value for name, each in config.params.items()}
    return parameters, {node.name: dict(node.remap_args) for node in config.nodes}


def test_simulator_gets_the_description_without_macros(planned):
    plan = planned()
    parameters, _ = loaded(plan)
    car = f1tenth_sim2d.load_car(parameters["/robot1/robot_description"], "robot1", "a test")
    assert (car.lidars[0].frame, car.lidars[0].beam_count) == ("front_laser", 541)
    assert car.parameters.wheelbase == pytest.approx(0.42)
    assert "xacro:macro" not in plan.description_file("robot1").read_text(encoding="utf-8")
    assert "/sim2d/cars/robot1/vehicle" not in parameters


def test_what_a_scenario_changes_is_changed_on_the_car_of_the_description(planned):
    parameters, _ = loaded(planned(OURS + "    mu: 0.7\n    model: kinematic\n"))
    car = f1tenth_sim2d.load_car(parameters["/robot1/robot_description"], "robot1", "a test")
    wanted = car.parameters
    wanted.mu, wanted.model = 0.7, "kinematic"
    changed = f1tenth_sim2d.VehicleParameters.load(parameters["/sim2d/cars/robot1/vehicle"])
    assert repr(changed) == repr(wanted)


def test_our_planner_gets_the_size_of_the_car(planned):
    parameters, _ = loaded(planned())
    planner = "/robot1/move_base/RacerROS"
    assert parameters[f"{planner}/wheelbase"] == pytest.approx(0.42)
    assert parameters[f"{planner}/min_turning_radius"] == pytest.approx(1.08 * 0.42 / 0.5463, rel=1e-3)
    corners = [[0.57, 0.18], [0.57, -0.18], [-0.13, -0.18], [-0.13, 0.18]]
    for name in ("global_costmap", "local_costmap"):
        assert [*map(pytest.approx, corners)] == parameters[f"/robot1/move_base/{name}/footprint"]


def test_our_planner_gets_the_topics_of_the_car(planned):
    arguments = "cars.robot1.description_arguments={perfect_odometry: true, scan: /beams}"
    parameters, names = loaded(planned("", settings=[arguments]))
    assert names["move_base"]["scan"] == "/beams"
    assert names["move_base"]["/robot1/cmd_vel"] == "/truck/cmd_vel"
    assert parameters["/robot1/move_base/RacerROS/cmd_angle_instead_rotvel"] is True


def test_another_driver_of_ours_gets_the_topics_of_the_car(planned):
    _, names = loaded(
        planned(f"{OURS}    driver: pursuit\n    laps: 1\n".replace("true", "true, scan: /beams"))
    )
    assert names["pure_pursuit"]["/robot1/scan"] == "/beams"


def test_our_planner_gets_the_odometry_of_the_wheels(planned):
    parameters, names = loaded(planned("", settings=["localization=amcl"]))
    assert names["move_base"]["odom"] == "/truck/odom"
    assert names["amcl"]["scan"] == "/front_laser/scan"


def test_faults_concern_the_odometry_that_the_car_has(planned):
    _, names = loaded(planned(f"{FOREIGN}    input_faults: [{{inputs: [odom], at: 1, until: 2}}]\n"))
    assert names["faulty_inputs"]["odom"] == "/truck/odom"
    assert names["planner"]["/truck/odom"] == "/robot1/odom_faulty"


def test_planner_of_the_car_gets_its_scans_by_the_proxy_driver(planned):
    _, names = loaded(planned(FOREIGN))
    assert names["proxy_driver"]["scan"] == "/front_laser/scan"
    assert names["planner"]["/front_laser/scan"] == "/robot1/proxy_driver/scan"
    assert "/robot1/scan" not in names["planner"]


def test_planner_of_f1tenth_simulator_gets_topics_and_frames_as_there(planned):
    driver = FOREIGN.replace("launch}", "launch, interface: f1tenth}")
    parameters, names = loaded(planned(driver))
    assert names["planner"]["/scan"] == "/robot1/proxy_driver/scan"
    assert names["planner"]["/drive"] == names["planner"]["/nav"] == "/robot1/drive"
    assert names["planner"]["/gt_pose"] == "/robot1/gt_pose"
    assert parameters["/sim2d/cars/robot1/frame_prefix"] == ""
    parameters, _ = loaded(planned(FOREIGN))
    assert parameters["/sim2d/cars/robot1/frame_prefix"] == "robot1/"


def test_bag_has_the_topics_of_the_car(planned):
    plan = planned(FOREIGN)
    write_launch_file(plan)
    assert plan.launch_file.read_text(encoding="utf-8").count('"/front_laser/scan", "/truck/cmd_vel"') == 1


TWICE = FOREIGN + "  - name: robot2\n    description: truck.xacro\n" + FOREIGN


@pytest.mark.parametrize(
    ("car", "description", "problem"),
    [
        (OURS, "none.xacro", "no such file: {folder}/none.xacro"),
        (OURS, "package://nobody/car.urdf", "package nobody not found"),
        (
            "",
            "broken.xacro",
            "{folder}/broken.xacro: xacro: name 'foo' is not defined when evaluating expression 'foo'"
            " when processing file: {folder}/broken.xacro",
        ),
        ("", "open.urdf", "{folder}/open.urdf: xacro: XML parsing error: mismatched tag: line 1, column 24"),
        ("", "empty.urdf", "{folder}/empty.urdf: "),
        (
            OURS.replace("}", ", has_lidar: false}"),
            "truck.xacro",
            "robot1: the driver 'race' needs a lidar, and {folder}/truck.xacro has none",
        ),
        (
            "    description_arguments: {driven_by: controllers}\n    driver: gap_follower\n    laps: 1\n",
            "truck.xacro",
            "robot1: the driver 'gap_follower' needs a car that takes geometry_msgs/Twist, and {folder}",
        ),
        (
            "",
            "truck.xacro",
            "robot1: the driver 'race' needs libf1tenth_perfect_odometry.so, and {folder}/truck.xacro",
        ),
        (
            f"{FOREIGN}    dropped_beams: 0.1\n",
            "truck.xacro",
            "robot1: 'dropped_beams' needs a lidar of 40 Hz, and {folder}/truck.xacro has none",
        ),
        (
            f"{FOREIGN}    description_arguments: {{driven_by: controllers}}\n"
            "    input_faults: [{inputs: [odom], at: 1, until: 2}]\n",
            "truck.xacro",
            "robot1: 'input_faults' needs libf1tenth_perfect_odometry.so or odometry of its wheels with the"
            " transform from 'odom', and {folder}/truck.xacro has none",
        ),
        (
            TWICE,
            "truck.xacro",
            "robot2: {folder}/truck.xacro has the topic /front_laser/scan, as robot1 has; ",
        ),
    ],
)
def test_what_does_not_fit_is_answered(planned, tmp_path, car, description, problem):
    (tmp_path / "broken.xacro").write_text(BROKEN, encoding="utf-8")
    (tmp_path / "open.urdf").write_text("<robot name='a'><link></robot>", encoding="utf-8")
    (tmp_path / "empty.urdf").write_text("<robot name='a'/>", encoding="utf-8")
    with pytest.raises(ScenarioError) as caught:
        planned(car, description)
    expected = problem.replace("{folder}", str(tmp_path))
    assert str(caught.value).startswith(f"{tmp_path}/sample.yaml: {expected}")


def test_arguments_without_a_description_are_answered(tmp_path):
    path = tmp_path / "sample.yaml"
    path.write_text(SCENARIO_TEXT.replace("    goals: circuit1\n", OURS), encoding="utf-8")
    with pytest.raises(ScenarioError, match="description_arguments is given without 'description'"):
        make_plan(str(path))


def test_old_results_count_only_for_the_same_description(planned, tmp_path):
    (tmp_path / "car.xacro").write_text(INCLUDING, encoding="utf-8")
    before = hash_inputs(planned(FOREIGN, "car.xacro"), "software")
    assert hash_inputs(planned(FOREIGN, "car.xacro"), "software") == before
    part = tmp_path / "truck.xacro"
    longer = part.read_text(encoding="utf-8").replace('value="0.42"', 'value="0.43"')
    planned(FOREIGN, "car.xacro")
    part.write_text(longer, encoding="utf-8")
    assert hash_inputs(make_plan(str(tmp_path / "sample.yaml"), tmp_path / "results"), "software") != before
