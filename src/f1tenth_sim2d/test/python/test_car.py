import copy

import pytest

import f1tenth_sim2d


def test_car_has_the_sensors_of_its_description(car):
    assert car.name == "robot1"
    assert [(lidar.topic, lidar.frame, lidar.beam_count) for lidar in car.lidars] == [("scan", "laser", 1081)]
    assert car.lidars[0].pose == pytest.approx((0.27, 0.0, 0.16, 0.0))
    assert sorted(bumper.topic for bumper in car.bumpers) == [
        "bumper_front",
        "bumper_left",
        "bumper_rear",
        "bumper_right",
    ]
    assert car.plugins == ["libf1tenth_perfect_odometry.so"]
    assert len(car.joints) == 6
    assert car.wheel_radius == pytest.approx(0.05)
    assert car.track_width == pytest.approx(0.2)


def test_car_ends_where_its_bumpers_do(car):
    assert car.extent == pytest.approx((-0.12, 0.44, -0.16, 0.16))


@pytest.mark.parametrize("kind", ["floating", "planar"])
def test_link_that_would_be_loose_is_told(car_text, kind):
    joint = '<parent link="base_link"/><child link="loose"/>'
    inertia = " ".join(f'{name}="0"' for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    inertial = f'<inertial><mass value="1"/><inertia {inertia}/></inertial>'
    loose = f'<link name="loose">{inertial}</link><joint name="free" type="{kind}">{joint}</joint></robot>'
    car = f1tenth_sim2d.load_car(car_text.replace("</robot>", loose), "robot1", "a test")
    (told,) = [each for each in car.warnings if "[free]" in each]
    assert f"a joint of type {kind} is left out: its link is held fast" in told


CONTROL = '<gazebo><plugin name="c" filename="libgazebo_ros_control.so"/></gazebo>'
ACKERMANN = """<gazebo><plugin name="a" filename="libgazebo_ros_ackermann_drive.so">
<commandTopic>/cmd</commandTopic><updateRate>50</updateRate></plugin></gazebo>"""


def with_plugin(car_text, plugin):
    return f1tenth_sim2d.load_car(car_text.replace("</robot>", f"{plugin}</robot>"), "robot1", "a test")


@pytest.mark.parametrize(
    ("plugin", "topic", "is_angle"),
    [("", "cmd_vel", False), (CONTROL, None, False), (ACKERMANN, "/cmd", True)],
)
def test_car_says_how_it_is_driven(car_text, plugin, topic, is_angle):
    made = with_plugin(car_text, plugin)
    assert (made.twist_topic, made.takes_steering_angle) == (topic, is_angle)


@pytest.mark.parametrize(
    ("plugin", "topic"),
    [
        ("", "odom"),
        (CONTROL, None),
        (ACKERMANN, "odom"),
        (ACKERMANN.replace("<update", "<odometryTopic>/wheels</odometryTopic><update"), "/wheels"),
        (ACKERMANN.replace("<update", "<publishTf>false</publishTf><update"), None),
        (ACKERMANN.replace("<update", "<odometryFrame>start</odometryFrame><update"), None),
    ],
)
def test_car_says_where_its_odometry_is(car_text, plugin, topic):
    assert with_plugin(car_text, plugin).odometry_topic == topic


def test_text_that_is_no_robot_is_a_load_error_with_its_source():
    with pytest.raises(f1tenth_sim2d.LoadError, match="^my text: car: is no robot description"):
        f1tenth_sim2d.load_car("<car/>", "robot1", "my text")


def test_vehicle_parameters_have_defaults_and_can_be_changed():
    parameters = f1tenth_sim2d.VehicleParameters()
    assert parameters.m == 3.74
    assert parameters.wheelbase == pytest.approx(0.3302)
    parameters.mu = 0.5
    assert parameters.mu == 0.5


def test_vehicle_parameters_are_read_from_a_file(tmp_path):
    path = tmp_path / "car.yaml"
    path.write_text("m: 4.5\n")
    assert f1tenth_sim2d.VehicleParameters.load(path).m == 4.5
    path.write_text("weight: 4.5\n")
    with pytest.raises(
        f1tenth_sim2d.LoadError, match=f"^{path}:1: unknown key 'weight', allowed are model, tire, m, l_f"
    ):
        f1tenth_sim2d.VehicleParameters.load(str(path))


def test_copied_parameters_are_their_own():
    parameters = f1tenth_sim2d.VehicleParameters()
    parameters.model, parameters.mu, parameters.tire.p_dy1 = "kinematic", 0.3, 0.9
    same = copy.copy(parameters)
    assert (same.model, same.mu, same.tire.p_dy1) == ("kinematic", 0.3, 0.9)
    same.mu, same.tire.p_dy1 = 0.5, 0.5
    assert (parameters.mu, parameters.tire.p_dy1) == (0.3, 0.9)
