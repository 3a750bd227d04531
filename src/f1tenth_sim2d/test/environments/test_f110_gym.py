"""What was written for f1tenth_gym drives here."""

from pathlib import Path

import numpy as np
import pytest
from f1tenth_sim2d.f110_gym import F110Env, Integrator, make

import f1tenth_sim2d

TRACK = Path(__file__).parents[4] / "data" / "tracks" / "hand_drawn"
FOLLOWER = Path(__file__).with_name("waypoint_follow.py")
THEIRS, OURS = "import gym\n", "import f1tenth_sim2d.f110_gym as gym\n"
KEYS = ["ego_idx", "scans", "poses_x", "poses_y", "poses_theta", "linear_vels_x", "linear_vels_y"]
KEYS += ["ang_vels_z", "collisions", "lap_times", "lap_counts"]
START = np.zeros((1, 3))


def drive(environment, steering, speed, steps):
    for _ in range(steps):
        answer = environment.step(np.tile([steering, speed], (environment.num_agents, 1)))
    return answer


def test_a_waypoint_follower_drives_two_laps_with_one_import_changed():
    text = FOLLOWER.read_text(encoding="utf-8")
    assert text.count(THEIRS) == 1
    follower: dict = {}
    exec(text.replace(THEIRS, OURS), follower)
    laptime, last = follower["main"](str(TRACK / "hand_drawn_map"), TRACK / "hand_drawn_raceline.csv")
    assert last["lap_counts"] == [2.0]
    assert last["collisions"] == [0.0]
    assert laptime == pytest.approx(last["lap_times"][0])
    assert 41.0 < laptime < 45.0


def test_what_is_observed_has_their_names_and_forms():
    environment = F110Env(map="circuit3", integrator=Integrator.Euler)
    poses = np.array([[0.0, 0.4, 0.0], [0.0, -0.4, -0.1]])
    observation, reward, done, info = environment.reset(poses)
    assert list(observation) == KEYS
    assert [scan.shape for scan in observation["scans"]] == [(1080,), (1080,)]
    assert observation["poses_x"] == pytest.approx([0.0, 0.0])
    assert observation["poses_y"] == pytest.approx([0.4, -0.4])
    assert observation["poses_theta"] == pytest.approx([0.0, 2 * np.pi - 0.1])
    assert (reward, done) == (0.01, False)
    assert info["checkpoint_done"].tolist() == [False, False]
    assert observation["lap_times"].tolist() == [0.01, 0.01]


def test_velocities_are_those_of_the_centre_of_mass():
    environment = make("f110_gym:f110-v0", map="circuit3", num_agents=1, timestep=0.02)
    environment.reset(START)
    before, *_ = drive(environment, 0.1, 1.5, 60)
    after, *_ = drive(environment, 0.1, 1.5, 1)
    moved = np.array([after[key][0] - before[key][0] for key in ("poses_x", "poses_y")]) / 0.02
    theta = (before["poses_theta"][0] + after["poses_theta"][0]) / 2
    ahead = np.array([np.cos(theta), np.sin(theta)])
    assert after["linear_vels_x"][0] == pytest.approx(moved @ ahead, abs=0.01)
    assert after["linear_vels_y"][0] == pytest.approx(moved @ [-ahead[1], ahead[0]], abs=0.01)
    turned = after["poses_theta"][0] - before["poses_theta"][0]
    assert after["ang_vels_z"][0] == pytest.approx(turned / 0.02, abs=0.01)


def test_a_contact_ends_the_episode():
    environment = F110Env(map="circuit1", num_agents=1)
    observation, _, done, _ = environment.reset(START)
    while not done:
        observation, _, done, info = environment.step(np.array([[0.0, 4.0]]))
    assert observation["collisions"].tolist() == [1.0]
    assert not info["checkpoint_done"].any()


def test_the_seed_is_that_of_the_noise():
    scans = [F110Env(map="circuit1", num_agents=1, seed=seed).reset(START)[0]["scans"] for seed in (1, 1, 2)]
    assert np.array_equal(scans[0], scans[1])
    assert not np.array_equal(scans[0], scans[2])


def test_params_are_theirs():
    environment = F110Env(map="circuit3", num_agents=1, params={"s_max": 0.5, "s_min": -0.5, "v_max": 2.0})
    environment.reset(START)
    observation, *_ = drive(environment, 0.0, 9.0, 100)
    assert observation["linear_vels_x"][0] == pytest.approx(2.0, abs=0.01)
    environment.update_params({"a_max": 1.0})
    observation, *_ = drive(environment, 0.0, 9.0, 1)
    assert observation["linear_vels_x"][0] == pytest.approx(2.0, abs=0.01)
    environment.reset(START)
    observation, *_ = drive(environment, 0.0, 9.0, 100)
    assert observation["linear_vels_x"][0] == pytest.approx(1.0, abs=0.03)


def test_another_map_can_be_taken():
    environment = F110Env(map="circuit3", num_agents=1)
    before = environment.reset(START)[0]["scans"][0]
    environment.update_map("circuit1", ".png")
    assert np.allclose(drive(environment, 0.0, 0.0, 1)[0]["scans"][0], before, atol=0.1)
    assert not np.array_equal(environment.reset(START)[0]["scans"][0], before)


def test_it_is_shown_in_a_window_without_their_callbacks():
    environment = F110Env(map="circuit1")
    with pytest.warns(UserWarning, match="the callback is not called"):
        environment.add_render_callback(print)
    environment.reset(np.array([[0.0, 0.4, 0.0], [0.0, -0.4, 0.0]]))
    environment.render(mode="human_fast")
    with pytest.raises(ValueError, match="mode: found 'ascii', allowed are human, human_fast"):
        environment.render(mode="ascii")
    environment.close()


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"map": "vegas"}, "map: found 'vegas', allowed are circuit1, .*, and paths of maps"),
        ({"map": None}, "map: missing; f1tenth_gym's default 'vegas' is not here, allowed are circuit1, .*"),
        ({"num_agents": 0}, "num_agents: found 0, allowed is a whole number from 1 to 64"),
        ({"timestep": 0.0}, "timestep: found 0.0, allowed is a number from 0.001 to 1.0"),
        ({"ego_idx": 2}, "ego_idx: found 2, allowed is a whole number from 0 to 1"),
        ({"seed": -1}, "seed: found -1, allowed is a whole number from 0"),
        ({"lidar_dist": 0.1}, "unknown keyword 'lidar_dist', allowed are map, map_ext, num_agents"),
        ({"params": {"wings": 1}}, "params: unknown key 'wings', allowed are mu, C_Sf, C_Sr, lf, lr"),
        ({"params": {"s_min": -0.3}}, r"params\['s_min'\]: found -0.3, allowed is -0.4189: the car steers"),
        ({"params": {"width": 0.4}}, r"params\['width'\]: found 0.4, allowed is 0.31: the shape is that of"),
    ],
)
def test_what_cannot_be_is_refused(settings, message):
    with pytest.raises(ValueError, match=message):
        F110Env(**{"map": "circuit1", **settings})


def test_a_map_may_be_named_with_its_extension():
    environment = make(map=str(TRACK / "hand_drawn_map.yaml"), num_agents=1)
    assert environment.map_name == str(TRACK / "hand_drawn_map")


def test_make_without_a_map_names_it():
    with pytest.raises(ValueError, match="map: missing"):
        make("f110_gym:f110-v0")


def test_a_map_without_its_image_is_refused(tmp_path):
    (tmp_path / "bare.yaml").write_text("image: bare.png\n")
    with pytest.raises(
        ValueError, match="map_ext: found '.png', allowed is the extension of an image beside"
    ):
        F110Env(map=str(tmp_path / "bare"))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda env: env.reset(np.zeros(3)), r"poses: found shape \(3,\), allowed is \(1, 3\)"),
        (lambda env: env.reset([[0.0, 1.0, 0.0]]), r"start: robot1: the start pose"),
        (lambda env: env.step(np.zeros(2)), r"action: found shape \(2,\), allowed is \(1, 2\)"),
        (lambda env: env.step([[np.nan, 0.0]]), "action: found a number that is not finite"),
        (lambda env: env.update_params({}, index=0), "index: found 0, allowed is -1"),
        (lambda env: env.update_params({"mu": -1.0}), "vehicle: robot1: mu is -1, allowed"),
    ],
)
def test_calls_that_cannot_be_change_nothing(call, message):
    environment = F110Env(map="circuit1", num_agents=1)
    environment.reset(START)
    with pytest.raises(ValueError, match=message):
        call(environment)
    assert drive(environment, 0.0, 1.0, 1)[0]["lap_times"] == pytest.approx([0.02])


def test_only_their_environment_is_made():
    with pytest.raises(ValueError, match="environment: found 'CartPole-v1', allowed are f110_gym:f110-v0"):
        make("CartPole-v1")


def test_it_starts_where_the_centre_of_mass_is_put():
    environment = F110Env(map="circuit3", num_agents=1, params={"lr": 0.2, "lf": 0.13})
    observation, *_ = environment.reset(np.array([[0.3, 0.1, 0.5]]))
    assert observation["poses_x"] == pytest.approx([0.3])
    assert observation["poses_y"] == pytest.approx([0.1])
    assert isinstance(environment._now.stage.place.world, f1tenth_sim2d.World)
