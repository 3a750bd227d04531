"""What the environment of one driver does."""

import numpy as np
import pytest
from conftest import straight_on


def drive(environment, action, steps):
    for _ in range(steps):
        answer = environment.step(action)
    return answer


def test_a_car_reaches_the_speed_that_is_asked_for(make):
    environment = make(observation=("velocity",))
    environment.reset(seed=1)
    observation, *_ = drive(environment, straight_on(), 60)
    assert observation["velocity"][0] == pytest.approx(2.5, abs=0.01)


def test_actions_can_be_in_units(make):
    environment = make(observation=("velocity", "steering"), normalized=False)
    environment.reset(seed=1)
    observation, *_ = drive(environment, np.array([0.1, 1.5], dtype=np.float32), 30)
    assert observation["velocity"][0] == pytest.approx(1.5, abs=0.02)
    assert observation["steering"][0] == pytest.approx(0.1, abs=1e-6)


def test_speeds_set_the_limits_of_actions(make):
    environment = make(observation=("velocity",), speeds=(1.0, 3.0))
    environment.reset(seed=1)
    observation, *_ = drive(environment, straight_on(-1.0), 60)
    assert observation["velocity"][0] == pytest.approx(1.0, abs=0.01)


def test_other_cars_have_other_limits_of_actions(make):
    vehicle = {"steering_max": (0.3, 0.5), "v_min": -1.0, "v_max": 4.0}
    limits = make(vehicle=vehicle, normalized=False).action_space
    assert limits.high == pytest.approx([0.5, 4.0])
    assert limits.low == pytest.approx([-0.5, -1.0])


def test_acceleration_and_steering_rate_are_followed(make):
    environment = make(
        observation=("velocity", "steering"), actions="acceleration", normalized=False, place="circuit3"
    )
    environment.reset(seed=1)
    drive(environment, np.array([0.0, 2.0], dtype=np.float32), 20)
    before = environment.step(np.array([0.2, 2.0], dtype=np.float32))[0]
    after = drive(environment, np.array([0.2, 2.0], dtype=np.float32), 10)[0]
    assert after["velocity"][0] - before["velocity"][0] == pytest.approx(2.0 * 0.25, abs=0.03)
    drive(environment, np.array([0.0, 0.0], dtype=np.float32), 2)
    assert after["steering"][0] == pytest.approx(0.2 * 11 * 0.025, abs=0.2 * 0.025)


def test_the_reward_is_progress_along_the_course(make):
    environment = make(observation=("course",))
    start, _ = environment.reset(seed=1)
    rewards, observation = 0.0, start
    for _ in range(80):
        observation, reward, *_ = environment.step(straight_on())
        rewards += reward
    assert rewards == pytest.approx(observation["course"][0] - start["course"][0], abs=1e-5)
    assert rewards > 4.0


def test_a_contact_costs_and_ends_the_episode(make):
    environment = make(observation=("contact",), contact_penalty=7.0)
    environment.reset(seed=1)
    for _ in range(400):
        observation, reward, terminated, truncated, info = environment.step(straight_on(0.0))
        if terminated:
            break
    assert terminated
    assert not truncated
    assert observation["contact"][0] == 1.0
    assert reward == pytest.approx(info["progress"][0] - 7.0)


def test_the_reward_can_be_a_function_of_the_results(make):
    environment = make(reward=lambda car: 10.0 * car["v_x"])
    environment.reset(seed=1)
    _, reward, _, _, info = drive(environment, straight_on(), 20)
    assert reward == pytest.approx(10.0 * info["v_x"][0])


def test_time_cuts_an_episode_off(make):
    environment = make(max_time=0.5)
    environment.reset(seed=1)
    ends = [environment.step(straight_on(-0.6))[2:4] for _ in range(20)]
    assert ends == [(False, False)] * 19 + [(False, True)]


def follow(environment, observation):
    """Steer along the centreline at 2 m/s."""
    _, offset, heading = observation["course"]
    steering = np.clip(-1.5 * offset - 1.2 * heading, -0.41, 0.41)
    return environment.step(np.array([steering, 2.0], dtype=np.float32))


def test_laps_are_counted_and_end_the_episode(make):
    environment = make(observation=("course", "laps"), laps=1, normalized=False)
    observation, _ = environment.reset(seed=1)
    terminated = truncated = False
    while not (terminated or truncated):
        observation, _, terminated, truncated, info = follow(environment, observation)
    assert terminated
    assert observation["laps"][0] == 1.0
    assert info["contact"][0] == 0.0
    assert info["distance"][0] == pytest.approx(environment._stage.place.course.length, abs=0.1)


def test_the_same_seed_gives_the_same_episode(make):
    settings = {"start": "random", "vehicle": {"mu": (0.7, 1.1), "m": (3.0, 4.0)}, "lidar_noise": (0.0, 0.02)}

    def episode(seed):
        environment = make(flatten=True, observation=("scan", "pose"), **settings)
        rows = [environment.reset(seed=seed)[0]]
        rows += [environment.step(straight_on())[0] for _ in range(20)]
        return np.array(rows)

    assert np.array_equal(episode(4), episode(4))
    assert not np.array_equal(episode(4), episode(5))


def test_each_reset_draws_anew(make):
    environment = make(start="random", observation=("pose",))
    places = [environment.reset(seed=3)[0]["pose"]] + [environment.reset()[0]["pose"] for _ in range(4)]
    assert len({tuple(place) for place in places}) == 5


def test_a_start_can_be_given(make):
    environment = make(observation=("pose",), cars=2)
    poses = [[1.0, 0.2, 0.1], [3.0, -0.2, 0.0]]
    observation, _ = environment.reset(seed=1, options={"poses": poses})
    assert observation["pose"] == pytest.approx(np.array(poses))


def test_cars_see_each_other(make):
    environment = make(cars=2, observation=("others",))
    observation, _ = environment.reset(options={"poses": [[0.0, 0.0, 0.0], [2.0, 0.3, 0.5]]})
    assert observation["others"][0] == pytest.approx([2.0, 0.3, 0.5, 0.0], abs=1e-6)


def test_a_grid_has_two_abreast(make):
    observation, _ = make(cars=5, observation=("pose",)).reset(seed=1)
    assert observation["pose"][:, 1] == pytest.approx([0.35, -0.35, 0.35, -0.35, 0.35], abs=1e-6)
    assert observation["pose"][:, 0] == pytest.approx([0.0, 0.0, -1.2, -1.2, -2.4], abs=1e-6)


def test_vehicle_numbers_are_the_cars(make):
    slow = make(observation=("velocity",), vehicle={"a_max": 1.0})
    slow.reset(seed=1)
    observation, *_ = drive(slow, straight_on(), 20)
    assert observation["velocity"][0] < 0.55


def test_a_picture_shows_the_car(make):
    environment = make(render_mode="rgb_array")
    environment.reset(seed=1)
    first = environment.render()
    drive(environment, straight_on(), 20)
    second = environment.render()
    assert first.dtype == np.uint8
    assert first.shape[2] == 3
    assert (first != second).any()


def test_a_camera_is_part_of_the_observation(make):
    environment = make(observation=("velocity", "camera", "depth"))
    observation, _ = environment.reset(seed=1)
    assert observation in environment.observation_space
    assert observation["camera"].shape == (376, 672, 3)
    later = environment.step(straight_on())[0]
    assert (later["camera"] != observation["camera"]).any()
    assert later["depth"].min() > 0.0
