import subprocess
import sys
import threading

import numpy as np
import pytest

import f1tenth_sim2d


def drive(simulation, seconds=1.0, speed=2.0):
    simulation.command(0, speed=speed, steering_angle=0.1)
    start = simulation.time
    for period in range(1, round(seconds / 0.025) + 1):
        simulation.advance_to(start + 0.025 * period)
        simulation.command(0, speed=speed, steering_angle=0.1)


def test_car_drives_as_commanded(simulation):
    drive(simulation)
    state = simulation.state(0)
    assert 0.5 < state.x < 2.0
    assert state.yaw > 0.05
    assert state.v_x > 1.0
    assert len(state.wheel_speeds) == 4
    np.testing.assert_allclose(simulation.poses(), [[state.x, state.y, state.yaw]])


def test_what_it_returns_says_what_it_holds(simulation):
    drive(simulation, seconds=0.5)
    state, odometry = simulation.state(0), simulation.wheel_odometry(0)
    assert repr(state).startswith(f"CarState(x={state.x!r}, y={state.y!r}, yaw={state.yaw!r}, v_x=")
    assert repr(odometry).endswith(f", speed={odometry.speed!r}, yaw_rate={odometry.yaw_rate!r})")
    assert "mu=0.7, " in repr(with_friction(0.7))


def with_friction(mu):
    parameters = f1tenth_sim2d.VehicleParameters()
    parameters.mu = mu
    return parameters


def test_twist_steers_as_cmd_vel_does(simulation):
    for _ in range(20):
        simulation.command_twist(0, linear_x=1.0, angular_z=0.5)
        simulation.advance_to(simulation.time + 0.1)
    assert simulation.state(0).yaw_rate == pytest.approx(0.5, rel=0.1)


def test_scan_sees_the_wall(simulation):
    ranges = simulation.scan(0, exact=True)
    assert ranges.dtype == np.float32
    assert ranges.shape == (1081,)
    assert ranges[540] == pytest.approx(4.9 - 0.27, abs=1e-3)


def test_scan_writes_into_the_array_given(simulation):
    out = np.full(1081, -1.0, dtype=np.float32)
    result = simulation.scan(0, out=out)
    assert np.shares_memory(result, out)
    assert (out != -1.0).all()
    np.testing.assert_array_equal(out, simulation.scan(0))


def read_only(array):
    array.flags.writeable = False
    return array


@pytest.mark.parametrize(
    ("out", "found"),
    [
        (np.zeros(1081), r"dtype float64 and shape \(1081,\)"),
        (np.zeros(1080, dtype=np.float32), r"dtype float32 and shape \(1080,\)"),
        (np.zeros((1081, 1), dtype=np.float32), r"dtype float32 and shape \(1081, 1\)"),
        (np.zeros(2162, dtype=np.float32)[::2], r"dtype float32 and shape \(1081,\)"),
        (read_only(np.zeros(1081, dtype=np.float32)), r"dtype float32 and shape \(1081,\)"),
    ],
)
def test_scan_refuses_arrays_that_do_not_fit(simulation, out, found):
    allowed = r"allowed is a writeable, contiguous numpy array of dtype float32 and shape \(1081,\)"
    with pytest.raises(ValueError, match=f"^out has {found}, {allowed}$"):
        simulation.scan(0, out=out)


def test_scan_refuses_what_is_no_array(simulation):
    with pytest.raises(ValueError, match="^out is no numpy array, allowed is a writeable"):
        simulation.scan(0, out=[0.0] * 1081)


def test_unknown_cars_and_lidars_are_index_errors(simulation):
    with pytest.raises(IndexError, match="^there is no car 1, only 0$"):
        simulation.state(1)
    with pytest.raises(IndexError, match="^lidar is 1, allowed are 0 to 0$"):
        simulation.scan(0, lidar=1)


def test_a_simulation_without_cars_says_so(world):
    with pytest.raises(IndexError, match="^there is no car 0$"):
        f1tenth_sim2d.Simulation(world).state(0)


def test_driving_into_the_wall_is_a_contact_of_the_front_bumper(simulation):
    touched = []
    while not touched and simulation.time < 5.0:
        simulation.command(0, speed=3.0, steering_angle=0.0)
        simulation.advance_to(simulation.time + 0.025)
        touched = simulation.contacts(0)
    assert touched[0].other_model == "wall"
    assert "bumper_front" in touched[0].own_collision
    assert touched[0].positions.shape[1] == 2
    assert touched[0].normals.shape == touched[0].positions.shape
    assert simulation.clearance(0) == pytest.approx(0.0, abs=1e-2)
    simulation.clear_contacts(0)
    assert simulation.contacts(0) == []


def test_clearance_is_the_distance_to_the_nearest_thing(simulation):
    assert simulation.clearance(0, limit=1.0) == 1.0
    assert simulation.clearance(0) == pytest.approx(2.55, abs=0.2)


def test_sensors_give_readings(simulation):
    drive(simulation, seconds=0.5)
    assert simulation.wheel_odometry(0).speed == pytest.approx(simulation.state(0).v_x, abs=0.2)
    imu = simulation.sample(0, "imu")
    assert {name: len(numbers) for name, numbers in imu.items()} == simulation.car(0).components["imu"]
    assert imu["angular_velocity"][2] == pytest.approx(simulation.state(0).yaw_rate, abs=0.1)
    assert imu["linear_acceleration"][2] == pytest.approx(9.8)


def test_unknown_components_are_refused_with_those_that_there_are(simulation):
    with pytest.raises(ValueError, match="component: found 'radar', allowed are lidar, camera, imu"):
        simulation.sample(0, "radar")


def test_models_have_poses(simulation):
    assert simulation.model_names() == ["wall", "post", "crate"]
    assert simulation.model_pose("crate") == pytest.approx((0.0, -3.0, 0.5), abs=1e-6)
    with pytest.raises(f1tenth_sim2d.Error, match="there is no model nothing"):
        simulation.model_pose("nothing")


@pytest.mark.parametrize("end", [float("nan"), float("inf"), 1e12])
def test_advancing_to_no_time_is_a_value_error(simulation, end):
    with pytest.raises(ValueError, match="^the time to advance to is not finite or beyond 1e9 s$"):
        simulation.advance_to(end)


@pytest.fixture
def selfish_threads():
    """Let a thread of Python keep the interpreter until it gives it away."""
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1000.0)
    yield
    sys.setswitchinterval(interval)


@pytest.mark.usefixtures("selfish_threads")
def test_other_threads_run_while_the_simulation_advances(simulation):
    go = threading.Event()
    ran = []
    thread = threading.Thread(target=lambda: (go.wait(), ran.append(True)))
    thread.start()
    go.set()
    assert ran == []
    for _ in range(1000):
        simulation.advance_to(simulation.time + 1.0)
        if ran:
            break
    assert ran == [True]
    thread.join()


def refusal(call):
    """The message of the RuntimeError that a call raises; empty if it raises none."""
    try:
        call()
    except RuntimeError as error:
        return str(error)
    return ""


@pytest.mark.usefixtures("selfish_threads")
def test_a_second_thread_is_refused_while_one_is_in_the_simulation(simulation):
    def advance(end, started):
        started.set()
        simulation.advance_to(end)

    questions = (simulation.trajectory_hash, lambda: simulation.scan(0), lambda: simulation.state(0))
    calls = (simulation.step, *questions)
    messages = []
    for attempt in range(1, 20):  # on a busy machine the other thread may be done before this one goes on
        started = threading.Event()
        thread = threading.Thread(target=advance, args=(500 * attempt, started))
        thread.start()
        started.wait()
        messages = [refusal(call) for call in calls]
        thread.join()
        if all(messages):
            break
    expected = "another thread is using this simulation: one thread at a time may call it"
    assert [message[: len(expected)] for message in messages] == [expected] * len(calls)
    assert refusal(simulation.step) == ""


def test_simulations_of_one_world_run_side_by_side(world, car):
    def driven():
        simulation = f1tenth_sim2d.Simulation(world)
        simulation.add_car(car)
        for _ in range(40):
            ranges = simulation.scan(0)
            simulation.command(0, 2.0, 0.1 if ranges[300] < ranges[780] else -0.1)
            simulation.advance_to(simulation.time + 0.025)
        hashes.append(simulation.trajectory_hash())

    hashes = []
    driven()
    threads = [threading.Thread(target=driven) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert hashes == hashes[:1] * 5


def test_control_period_of_the_hash_is_checked(world):
    with pytest.raises(ValueError, match="^control_period is 0.000000 s, allowed is physics_step to 10 s$"):
        f1tenth_sim2d.Simulation(world, control_period=0.0)


# Says how much memory one simulation of a world takes, with the world, and 63 more of them.
MEMORY_OF_SIMULATIONS = """
import sys
from pathlib import Path
import f1tenth_sim2d

def memory():
    return int(Path("/proc/self/statm").read_text().split()[1])

before = memory()
world = f1tenth_sim2d.load_world(sys.argv[1])
first = f1tenth_sim2d.Simulation(world)
of_one = memory() - before
others = [f1tenth_sim2d.Simulation(world) for _ in range(63)]
print(of_one, memory() - before - of_one)
"""


def test_simulations_share_the_walls_of_their_world(tmp_path):
    post = "<geometry><cylinder><radius>0.05</radius><length>1</length></cylinder></geometry>"
    posts = [
        f"<collision name='c{i}'><pose>{0.5 * (i % 60)} {0.5 * (i // 60)} 0.5 0 0 0</pose>{post}</collision>"
        for i in range(6000)
    ]
    path = tmp_path / "posts.world"
    path.write_text(
        f"<sdf version='1.6'><world name='posts'><model name='posts'><static>true</static>"
        f"<link name='l'>{''.join(posts)}</link></model></world></sdf>"
    )
    # In a process of its own: in this one, memory that other tests have given back would be taken again.
    command = [sys.executable, "-c", MEMORY_OF_SIMULATIONS, str(path)]
    said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    of_one, of_others = (int(pages) for pages in said.split())
    assert of_others < of_one


def test_everything_public_has_a_docstring():
    undocumented = [
        name for name, thing in vars(f1tenth_sim2d).items() if not name.startswith("_") and not thing.__doc__
    ]
    assert undocumented == []
