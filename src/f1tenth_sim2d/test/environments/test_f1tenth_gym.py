"""What was written for f1tenth_gym 1.0 drives here."""

import shutil
from pathlib import Path

import gymnasium
import numpy as np
import pytest
from f1tenth_sim2d.f1tenth_gym import F110Env
from f1tenth_sim2d.f110_gym import make

TRACK = Path(__file__).parents[4] / "data" / "tracks" / "hand_drawn"
CONFIG = {
    "map": "circuit1",
    "num_agents": 1,
    "timestep": 0.01,
    "integrator": "rk4",
    "model": "st",
    "control_input": ["speed", "steering_angle"],
    "observation_config": {"type": "kinematic_state"},
    "params": {"mu": 1.0},
}
START = np.zeros((1, 3))


def test_a_loop_written_for_it_drives():
    env = make("f1tenth_gym:f1tenth-v0", config=CONFIG, render_mode="rgb_array")
    observation, info = env.reset(seed=1, options={"poses": START})
    for _ in range(100):
        observation, reward, done, truncated, info = env.step(np.array([[0.05, 2.0]]))
    agent = observation[env.agent_ids[0]]
    assert list(agent) == ["pose_x", "pose_y", "delta", "linear_vel_x", "pose_theta"]
    assert agent["delta"] == pytest.approx(0.05, abs=1e-3)
    assert agent["linear_vel_x"] == pytest.approx(2.0, abs=0.05)
    assert (reward, done, truncated, info["checkpoint_done"].tolist()) == (0.01, False, False, [False])
    assert env.render().shape[2] == 3


def test_both_versions_drive_the_same():
    poses = np.array([[0.0, 0.4, 0.0], [0.0, -0.4, 0.0]])
    new, old = make(config={"map": "circuit3"}), make(map="circuit3")
    observation, _ = new.reset(options={"poses": poses})
    assert np.array_equal(observation["scans"], np.float32(old.reset(poses)[0]["scans"]))
    for _ in range(20):
        observation, *_ = new.step(np.tile([0.1, 2.0], (2, 1)))
        expected, *_ = old.step(np.tile([0.1, 2.0], (2, 1)))
    assert observation["poses_x"].tolist() == np.float32(expected["poses_x"]).tolist()


def test_without_poses_cars_stand_at_the_start_line():
    observation, _ = F110Env({**CONFIG, "observation_config": {"type": "original"}}).reset()
    assert observation["poses_x"] == pytest.approx([0.0], abs=0.2)
    assert observation["poses_y"] == pytest.approx([0.0], abs=1e-3)


def test_random_starts_follow_the_seed():
    env = F110Env({**CONFIG, "reset_config": {"type": "rl_random_static"}})
    starts = [env.reset(seed=seed)[0]["agent_0"]["pose_x"] for seed in (1, 1, 2)]
    assert starts[0] == starts[1] != starts[2]


def test_features_are_chosen():
    features = ["scan", "collision", "beta"]
    env = F110Env({**CONFIG, "observation_config": {"type": "features", "features": features}})
    agent = env.reset()[0]["agent_0"]
    assert list(agent) == features
    assert agent["scan"].shape == (1080,)


def test_it_is_an_environment_of_gymnasium():
    env = F110Env({**CONFIG, "num_agents": 2})
    assert isinstance(env, gymnasium.Env)
    assert env.unwrapped is env
    action = env.action_space.sample()
    assert action.shape == (2, 2)
    env.reset()
    env.step(action)


def test_the_track_is_the_line_to_follow():
    env = F110Env(CONFIG)
    line = env.unwrapped.track.raceline
    with pytest.warns(UserWarning, match="the callback is not called"):
        env.unwrapped.add_render_callback(line.render_waypoints)
    assert line is not None
    x, y, length = line.xs, line.ys, env._now.stage.place.course.length
    assert line.n == len(line.yaws) == len(line.vxs)
    assert length * 0.9 < line.ss[-1] < length
    ahead = np.column_stack([np.roll(x, -1) - x, np.roll(y, -1) - y])
    steps = np.hypot(*ahead.T)
    along = (ahead * np.column_stack([np.cos(line.yaws), np.sin(line.yaws)])).sum(axis=1)
    assert (along > 0.9 * steps).all()
    assert (line.ks * steps).sum() == pytest.approx(2 * np.pi, rel=0.1)


def test_a_raceline_beside_the_map_is_read():
    track = F110Env({**CONFIG, "map": str(TRACK / "hand_drawn_map")}).track
    table = np.loadtxt(TRACK / "hand_drawn_raceline.csv", delimiter=";")
    assert np.array_equal(track.raceline.xs, table[:, 1])
    assert np.array_equal(track.raceline.vxs, table[:, 5])
    assert track.centerline.vxs.max() == 1.0


@pytest.mark.parametrize("text", ["1;2;3\n", "s;x;y;psi;kappa;vx;ax\n"])
def test_a_raceline_that_is_no_table_is_refused(tmp_path, text):
    copy = shutil.copytree(TRACK, tmp_path / "track")
    (copy / "hand_drawn_raceline.csv").write_text(text)
    with pytest.raises(ValueError, match="hand_drawn_raceline.csv: found no table of numbers, allowed are"):
        F110Env({**CONFIG, "map": str(copy / "hand_drawn_map")}).track  # noqa: B018


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"scale": 2.0}, "config: unknown key 'scale', allowed are map, map_ext, num_agents"),
        ({"model": "mb"}, "model: found 'mb', allowed are st, ks"),
        ({"control_input": ["accl", "steering_speed"]}, "control_input: found"),
        ({"observation_config": {"type": "lidar"}}, "observation_config: type: found 'lidar', allowed are"),
        ({"map": "vegas"}, "map: found 'vegas', allowed are circuit1"),
    ],
)
def test_what_cannot_be_is_refused(change, message):
    with pytest.raises(ValueError, match=message):
        F110Env({**CONFIG, **change})
