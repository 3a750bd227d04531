"""Environments write their episodes down as scenarios do."""

import gymnasium
import numpy as np
import pytest
from f1tenth_judge.record.record import read_record
from f1tenth_judge.record.replay import read_replay
from f1tenth_sim2d.environments import ENVIRONMENT, recording, register
from f1tenth_sim2d.environments.car import Lidar, load_cars
from f1tenth_sim2d.environments.place import find_place
from result_schema import valid_result

import f1tenth_sim2d

register()


def drive(folder, steps, action=(0.0, -0.4), **settings):
    """Drive, and return what was told of the last step."""
    environment = gymnasium.make(ENVIRONMENT, place="circuit1", beams=20, record=folder, **settings)
    environment.reset(seed=1)
    ended, count = False, 0
    while not ended and count < steps:
        *_, terminated, truncated, info = environment.step(np.array(action, dtype=np.float32))
        ended, count = terminated or truncated, count + 1
    environment.close()
    return info


def result(folder, number=1):
    return valid_result(folder / f"episode_{number:04d}" / "result.json")


def test_the_record_is_what_was_driven(tmp_path):
    info = drive(tmp_path, 30)
    track = read_record(tmp_path / "episode_0001" / "trajectory.csv").tracks["robot1"]
    assert track.time == pytest.approx(0.025 * np.arange(1, 31))
    assert track.x[-1] == info["x"][0]
    assert track.steering_angle[-1] == info["steering_angle"][0]
    assert 0.0 < track.clearance.min() < 2.0
    assert result(tmp_path)["trajectory_hash"] == track.hash[-1]


def test_the_hash_is_that_of_the_simulation(tmp_path):
    drive(tmp_path, 20, (0.125, 2.5), normalized=False)
    place = find_place("circuit1")
    simulation = f1tenth_sim2d.Simulation(place.world, 0.001, 9, 0.025)
    car = simulation.add_car(load_cars(["robot1"], Lidar(20, 4.7, 10.0))[0])
    for period in range(20):
        simulation.command(car, 2.5, 0.125)
        simulation.advance_to(0.025 * (period + 1))
    assert result(tmp_path)["trajectory_hash"] == simulation.trajectory_hash()


@pytest.mark.parametrize(
    ("settings", "action", "verdict", "passed"),
    [
        ({"max_time": 0.5}, (0.0, -0.4), "timeout", True),
        ({"max_time": 0.5, "laps": 1}, (0.0, -0.4), "timeout", False),
        ({"laps": 1}, (0.0, 0.0), "collision", False),
    ],
)
def test_an_episode_has_a_verdict(tmp_path, settings, action, verdict, passed):
    drive(tmp_path, 1000, action, **settings)
    found = result(tmp_path)
    assert (found["verdict"], found["passed"]) == (verdict, passed)
    assert bool(found["contacts"]) == (verdict == "collision")


def test_laps_have_times(tmp_path):
    environment = gymnasium.make(
        ENVIRONMENT, place="circuit1", observation=("course",), normalized=False, laps=1, record=tmp_path
    )
    observation, _ = environment.reset(seed=1)
    terminated = False
    while not terminated:
        _, offset, heading = observation["course"]
        steering = np.clip(-1.5 * offset - 1.2 * heading, -0.41, 0.41)
        observation, _, terminated, _, info = environment.step(np.array([steering, 2.0], dtype=np.float32))
    environment.close()
    found = result(tmp_path)
    assert found["verdict"] == "success"
    assert found["cars"]["robot1"]["lap_times"] == [pytest.approx(info["time"])]


def test_the_report_shows_every_episode(tmp_path):
    environment = gymnasium.make(ENVIRONMENT, place="circuit1", record=tmp_path, max_time=0.2)
    for _ in range(3):
        environment.reset(seed=2)
        environment.step(np.zeros(2, dtype=np.float32))
    environment.close()
    assert [result(tmp_path, number)["verdict"] for number in (1, 2, 3)] == ["aborted"] * 3
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert page.count('id="replay-') == 3
    replay = read_replay(tmp_path / "episode_0003" / "replay.json.gz")
    assert len(replay.walls.outlines) > 3
    assert len(replay.road) > 20
    assert replay.lidars["robot1"][5] == 10.0


def test_several_drivers_are_recorded_until_the_last_one_ends(tmp_path):
    environment = f1tenth_sim2d.parallel_env(place="circuit1", record=tmp_path, max_time=5.0)
    environment.reset(seed=1)
    while environment.agents:
        actions = {agent: np.array([0.0, 0.0 if agent == "car_0" else -0.6]) for agent in environment.agents}
        environment.step(actions)
    environment.close()
    tracks = read_record(tmp_path / "episode_0001" / "trajectory.csv").tracks
    assert set(tracks) == {"car_0", "car_1"}
    assert result(tmp_path)["contacts"][0]["car"] == "car_0"


def test_a_folder_with_episodes_is_refused(tmp_path):
    drive(tmp_path, 2)
    with pytest.raises(ValueError, match=r"record: found episodes in .*, allowed is a folder without"):
        drive(tmp_path, 2)


def test_recording_changes_nothing(tmp_path):
    assert drive(tmp_path, 50)["x"] == drive(None, 50)["x"]


def test_without_the_package_of_the_report_it_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(recording, "RECORDER", "f1tenth_judge.none")
    with pytest.raises(
        ValueError, match=r"^record: No module named .*; the report is a part of f1tenth_judge$"
    ):
        gymnasium.make(ENVIRONMENT, place="circuit1", record=tmp_path / "episodes")
    assert not (tmp_path / "episodes").exists()
