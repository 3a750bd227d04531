"""Cars and models that come, go and are put elsewhere."""

import math

import numpy as np
import pytest
from conftest import CAR

import f1tenth_sim2d

BOX = """<robot name="box"><link name="box">
<inertial><mass value="2"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
<collision><geometry><box size="0.4 0.4 0.4"/></geometry></collision></link></robot>"""


def named(car_text, name):
    return f1tenth_sim2d.load_car(car_text, name, name)


@pytest.fixture
def car_text():
    return CAR.read_text()


def box(name="box", x=0.0, y=0.0):
    (model,) = f1tenth_sim2d.load_model(BOX, name, "box.urdf", x=x, y=y, z=0.2)
    return model


@pytest.mark.parametrize("yaw", [math.nan, math.inf])
def test_a_model_without_a_direction_is_refused(yaw):
    message = r"^box.urdf: robot\[box\]: has a rotation that is not finite$"
    with pytest.raises(f1tenth_sim2d.LoadError, match=message):
        f1tenth_sim2d.load_model(BOX, "box", "box.urdf", yaw=yaw)


def test_parameters_are_those_of_the_description(world, car_text):
    heavy = named(car_text.replace('mass value="3.0"', 'mass value="30.0"'), "heavy")
    simulation = f1tenth_sim2d.Simulation(world)
    car = simulation.add_car(heavy)
    assert heavy.parameters.m > 30.0
    assert simulation.parameters(car).m == heavy.parameters.m


def test_parameters_that_are_given_count(world, car):
    simulation = f1tenth_sim2d.Simulation(world)
    own = f1tenth_sim2d.VehicleParameters()
    own.m = 5.0
    assert simulation.parameters(simulation.add_car(car, own)).m == 5.0


def test_a_car_leaves_and_the_other_keeps_its_id(world, car_text):
    simulation = f1tenth_sim2d.Simulation(world)
    first = simulation.add_car(named(car_text, "robot1"))
    second = simulation.add_car(named(car_text, "robot2"), x=-2.0)
    simulation.remove_car(first)
    assert simulation.cars == [second]
    assert simulation.car(second).name == "robot2"
    assert simulation.poses().shape == (1, 3)
    with pytest.raises(IndexError, match="^there is no car 0, only 1$"):
        simulation.remove_car(first)


def test_a_car_is_placed_with_a_velocity(simulation):
    simulation.place_car(0, 1.0, 2.0, 0.3, v_x=3.0, v_y=0.2, yaw_rate=0.4)
    state = simulation.state(0)
    assert (state.x, state.y, state.yaw) == pytest.approx((1.0, 2.0, 0.3))
    assert (state.v_x, state.v_y, state.yaw_rate) == pytest.approx((3.0, 0.2, 0.4))
    with pytest.raises(f1tenth_sim2d.Error, match="is not free: it overlaps model wall"):
        simulation.place_car(0, 5.0, 0.0, 0.0)
    assert simulation.state(0).x == pytest.approx(1.0)


def test_the_model_of_motion_is_chosen_by_name(world, car):
    parameters = f1tenth_sim2d.VehicleParameters()
    assert parameters.model == "single_track"
    parameters.model = "single_track_drift"
    parameters.tire.p_dy1 = 1.2
    simulation = f1tenth_sim2d.Simulation(world)
    car = simulation.add_car(car, parameters)
    assert simulation.parameters(car).model == "single_track_drift"
    assert simulation.parameters(car).tire.p_dy1 == 1.2
    with pytest.raises(f1tenth_sim2d.Error, match="^model is 'drift', allowed are single_track, kinematic"):
        parameters.model = "drift"


def test_a_model_comes_is_seen_and_goes(simulation):
    before = simulation.scan(0, exact=True)[540]
    simulation.add_model(box(x=2.0))
    assert simulation.model_names()[-1] == "box"
    assert simulation.scan(0, exact=True)[540] == pytest.approx(2.0 - 0.2 - 0.27, abs=1e-3)
    with pytest.raises(f1tenth_sim2d.Error, match="there is already a model of this name"):
        simulation.add_model(box(x=3.0))
    simulation.remove_model("box")
    assert simulation.scan(0, exact=True)[540] == before
    with pytest.raises(f1tenth_sim2d.Error, match="there is no model box"):
        simulation.remove_model("box")


def test_scans_of_all_cars_come_in_one_array(world, car_text):
    simulation = f1tenth_sim2d.Simulation(world, seed=3)
    cars = [simulation.add_car(named(car_text, f"robot{i}"), x=-1.5 * i) for i in range(3)]
    simulation.remove_car(cars.pop(1))
    out = np.empty((2, simulation.car(0).lidars[0].beam_count), np.float32)
    assert simulation.scans(out=out) is out
    np.testing.assert_array_equal(out, [simulation.scan(car) for car in cars])
    exact = [simulation.scan(car, exact=True) for car in cars]
    np.testing.assert_array_equal(simulation.scans(exact=True), exact)
    with pytest.raises(
        ValueError, match=r"^out has dtype float32 and shape \(2, 7\), allowed is .* shape \(2, "
    ):
        simulation.scans(out=np.empty((2, 7), np.float32))
    with pytest.raises(IndexError, match="^lidar is 1, allowed are 0 to 0$"):
        simulation.scans(lidar=1)
    assert f1tenth_sim2d.Simulation(world).scans().shape == (0, 0)


def test_scans_of_unlike_lidars_are_refused(world, car_text):
    simulation = f1tenth_sim2d.Simulation(world)
    simulation.add_car(named(car_text, "robot1"))
    samples = simulation.car(0).lidars[0].beam_count
    other = car_text.replace(f"<samples>{samples}</samples>", "<samples>7</samples>")
    simulation.add_car(named(other, "robot2"), x=-2.0)
    with pytest.raises(
        ValueError, match=f"^lidar 0 of robot2 has 7 beams, that of robot1 {samples}: one array"
    ):
        simulation.scans()


def test_rays_meet_what_the_beams_of_a_lidar_meet(simulation):
    simulation.place_car(0, 0.5, 1.0, 0.4)
    lidar = simulation.car(0).lidars[0]
    x, y, z, yaw = lidar.pose
    angles = np.linspace(lidar.angle_min, lidar.angle_max, lidar.beam_count)
    rays = simulation.cast_rays(0, angles, x=x, y=y, height=z, yaw=yaw, range_max=lidar.range_max)
    np.testing.assert_allclose(rays, simulation.scan(0, exact=True), rtol=1e-6)
    assert np.isinf(simulation.cast_rays(0, [math.pi], range_max=1.0))
    with pytest.raises(ValueError, match=r"^directions has 2 dimensions, allowed is 1: shape \(n,\)$"):
        simulation.cast_rays(0, np.zeros((2, 2)))


@pytest.mark.parametrize(
    ("number", "text"),
    [
        ({"directions": [0.0, math.inf]}, "direction (rad) of a ray is inf, allowed is a finite number"),
        ({"x": math.nan}, "x (m) of the rays is nan, allowed is a finite number"),
        ({"y": -math.inf}, "y (m) of the rays is -inf, allowed is a finite number"),
        ({"yaw": math.nan}, "yaw (rad) of the rays is nan, allowed is a finite number"),
        ({"height": math.inf}, "height (m) of the rays is inf, allowed is a finite number"),
        ({"range_max": math.nan}, "largest range (m) of the rays is nan, allowed is 0 or more"),
        ({"range_max": -1.0}, "largest range (m) of the rays is -1, allowed is 0 or more"),
    ],
)
def test_rays_from_and_to_nowhere_are_refused(simulation, number, text):
    with pytest.raises(f1tenth_sim2d.Error) as raised:
        simulation.cast_rays(0, **{"directions": [0.0], **number})
    assert str(raised.value) == f"{simulation.car(0).name}: {text}"
