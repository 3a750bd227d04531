"""Mistakes are answered with what was found and what is allowed, and change nothing."""

import gymnasium
import numpy as np
import pytest
from conftest import straight_on
from f1tenth_sim2d.environments import ENVIRONMENT, register
from f1tenth_sim2d.environments.car import Lidar, load_cars

import f1tenth_sim2d


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        (
            {"place": "nowhere"},
            "place: found 'nowhere', allowed are circuit1, circuit2, circuit3, circuit4, ",
        ),
        ({"place": "/none.world"}, "place: found '/none.world', allowed are circuit1"),
        ({"wheels": 3}, "unknown setting 'wheels', allowed are place, cars, observation"),
        ({"cars": 0}, "cars: found 0, allowed is a whole number from 1 to 64"),
        ({"cars": True}, "cars: found True"),
        (
            {"observation": ["radar"]},
            "observation: found 'radar', allowed are scan, pose, velocity, steering, ",
        ),
        ({"observation": []}, r"observation: found \[\], allowed is a list of names of parts"),
        ({"observation": ["scan", "scan"]}, "allowed is each part once"),
        ({"actions": "torque"}, "actions: found 'torque', allowed are speed, acceleration"),
        ({"start": "pit"}, "start: found 'pit', allowed are grid, random"),
        ({"place": 3}, "place: found '3', allowed are circuit1"),
        ({"flatten": "no"}, "flatten: found 'no', allowed are True, False"),
        ({"speeds": 5.0}, r"speeds: found 5.0, allowed is \(least, greatest\), from -100.0 to 100.0"),
        ({"speeds": (0.0, 150.0)}, r"speeds: found \(0.0, 150.0\), allowed is \(least, greatest\), from"),
        ({"reward": 3}, "reward: found 3, allowed is a function of a car's results"),
        ({"record": 3}, "record: found 3, allowed is the path of a folder"),
        ({"beams": 1}, "beams: found 1, allowed is a whole number from 2 to 100000"),
        ({"beams": 2.5}, "beams: found 2.5, allowed is a whole number from 2 to 100000"),
        ({"field_of_view": 7.0}, "field_of_view: found 7.0, allowed is a number from 1e-06 to 6.2832"),
        ({"range_max": float("nan")}, "range_max: found nan, allowed is a number from 0.1 to 1000.0"),
        ({"period": 0.0}, "period: found 0.0, allowed is a number from 0.001 to 10.0"),
        ({"physics_step": 0.05}, "physics_step: found 0.05, allowed is a number from 1e-05 to 0.02"),
        ({"max_time": float("nan")}, "max_time: found nan"),
        ({"laps": 0}, "laps: found 0, allowed is a whole number from 1 to 1000000"),
        ({"vehicle": {"wings": 2.0}}, "vehicle: unknown key 'wings', allowed are C_Sf, C_Sr, I_y_w, I_z"),
        ({"vehicle": {"mu": (1.0, 0.5)}}, r"vehicle\['mu'\]: found \(1.0, 0.5\), allowed is a number or"),
        ({"vehicle": "car.yaml"}, "vehicle: found 'car.yaml', allowed are keys with numbers or"),
        ({"vehicle": {"model": 1}}, r"vehicle\['model'\]: found 1, allowed is a name"),
        ({"vehicle": {"model": "bicycle"}}, "vehicle: model is 'bicycle', allowed are single_track, "),
        ({"vehicle": {"m": -1.0}}, r"vehicle: robot1: mass \(kg\) is -1, allowed is"),
        ({"vehicle": {"mu": (-1.0, 1.0)}}, "vehicle: robot1: mu is -1, allowed are numbers greater than 0"),
        ({"vehicle": {"steering_max": 7.0}}, "vehicle: robot1: steering_max is 7, allowed are"),
        (
            {"vehicle": {"v_max": (5.0, 150.0)}},
            r"vehicle: an action can ask for 150 m/s \(v_max\), allowed is up to 100 m/s",
        ),
        (
            {"vehicle": {"v_min": -99.5}, "actions": "acceleration", "speeds": (0.0, 1.0)},
            r"vehicle: an action can ask for 100.451 m/s \(-v_min \+ a_max / speed_gain\), allowed is up to",
        ),
        (
            {"vehicle": {"speed_gain": 0.0}, "actions": "acceleration"},
            "vehicle: robot1: speed_gain is 0, allowed are numbers greater than 0",
        ),
        ({"lidar_noise": -0.1}, "lidar_noise: found -0.1, allowed is a number from 0.0 or"),
        ({"render_mode": "ascii"}, "render_mode: found 'ascii', allowed are None, rgb_array, human"),
    ],
    ids=lambda value: "" if isinstance(value, str) else "-".join(map(str, value)),
)
@pytest.mark.filterwarnings("ignore:.*render mode")  # Gymnasium's own, before ours
def test_settings(settings, message):
    with pytest.raises(ValueError, match=message):
        gymnasium.make(ENVIRONMENT, **{"place": "circuit1", **settings})


def test_a_place_is_needed():
    with pytest.raises(ValueError, match="place is missing: the name of a circuit"):
        gymnasium.make(ENVIRONMENT)


def test_a_broken_place_is_named(tmp_path):
    world = tmp_path / "broken.world"
    world.write_text("<sdf")
    with pytest.raises(f1tenth_sim2d.LoadError, match="broken.world"):
        gymnasium.make(ENVIRONMENT, place=world)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1, 2\n3, 4\n", "gives no widths of the road, allowed are lines of x_m, y_m, w_tr_right_m"),
        ("1, 2, 1, 1\n2, 2, 1, 1\n", "a course of 2 points, allowed are 3 or more"),
    ],
)
def test_a_broken_centreline_is_named(tmp_path, text, message):
    (tmp_path / "bare.world").write_text("<sdf version='1.7'><world name='bare'/></sdf>")
    (tmp_path / "bare_centerline.csv").write_text(text)
    with pytest.raises(ValueError, match=f"bare_centerline.csv: .*{message}"):
        gymnasium.make(ENVIRONMENT, place=tmp_path / "bare.world")


@pytest.mark.parametrize(
    "settings", [{"start": "random"}, {"laps": 2}, {"observation": ["course"]}], ids=["start", "laps", "part"]
)
def test_what_needs_a_course_says_so(tmp_path, settings):
    (tmp_path / "bare.world").write_text("<sdf version='1.7'><world name='bare'/></sdf>")
    with pytest.raises(
        ValueError, match="bare has no course, allowed are circuits, and worlds and maps with"
    ):
        gymnasium.make(ENVIRONMENT, place=tmp_path / "bare.world", **settings)


def test_actions(make):
    environment = make(observation=("pose",))
    with pytest.raises(ValueError, match="step before the first reset"):
        environment.step(straight_on())
    environment.reset(seed=1)
    with pytest.raises(ValueError, match=r"action: found shape \(3,\), allowed is \(2,\)"):
        environment.step(np.zeros(3))
    with pytest.raises(ValueError, match="action: found a number that is not finite"):
        environment.step(np.array([np.nan, 0.0]))
    assert environment.step(straight_on())[4]["time"] == 0.025


def test_a_step_that_is_refused_does_not_count():
    world = f1tenth_sim2d.empty_world()
    environments = f1tenth_sim2d.Environments(
        world, load_cars(["robot1"], Lidar(2, 1.0, 10.0)), None, ["pose"]
    )
    environments.reset(0, 0, [f1tenth_sim2d.VehicleParameters()], np.zeros((1, 4)), [0.0])
    driven = np.ones((1, 1), dtype=bool)
    with pytest.raises(f1tenth_sim2d.Error, match="commanded speed"):
        environments.step(np.array([[[0.0, 200.0]]]), driven)
    environments.step(np.zeros((1, 1, 2)), driven)
    assert environments.times.tolist() == [0.025]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"place": 1}, "options: unknown key 'place', allowed are poses, noise_seed"),
        ({"poses": [[0.0, 0.0]]}, r"options\['poses'\]: .* allowed are finite numbers of shape \(1, 3\)"),
        ({"poses": "here"}, r"options\['poses'\]: .* allowed are numbers of shape \(1, 3\)"),
        ({"noise_seed": -1}, r"options\['noise_seed'\]: found -1, allowed is a whole number from 0 to"),
        ({"noise_seed": "x"}, r"options\['noise_seed'\]: found 'x', allowed is a whole number"),
        ({"poses": [[0.0, 1.0, 0.0]]}, r"start: robot1: the start pose \(0, 1, 0\)"),
        (
            {"poses": [[0.0, 2.0, 0.0]]},
            r"options\['poses'\]\[0\]: found \(0, 2\), 2.00 m to the left of the course",
        ),
    ],
)
def test_a_bad_reset_leaves_the_episode(make, options, message):
    environment = make()
    environment.reset(seed=1)
    environment.step(straight_on())
    with pytest.raises(ValueError, match=message):
        environment.reset(options=options)
    assert environment.step(straight_on())[4]["time"] == 0.05


def test_numbers_may_be_those_of_numpy(make):
    environment = make(cars=np.int64(2), max_time=np.float32(5.0), flatten=np.bool_(True))
    assert environment.reset(seed=1)[0].shape[0] == 2


def test_a_closed_environment_is_refused(make):
    environment = make()
    environment.close()
    environment.close()
    for call in (environment.reset, environment.render, lambda: environment.step(straight_on())):
        with pytest.raises(ValueError, match="the environment is closed"):
            call()


def test_parallel_actions_belong_to_its_cars():
    environment = f1tenth_sim2d.parallel_env(place="circuit1")
    environment.reset(seed=1)
    with pytest.raises(ValueError, match=r"actions: found those of \['car_0'\], allowed are those of"):
        environment.step({"car_0": straight_on()})
    with pytest.raises(ValueError, match=r"actions\['car_1'\]: found shape \(1,\), allowed is \(2,\)"):
        environment.step({"car_0": straight_on(), "car_1": np.zeros(1)})


def test_what_is_not_installed_is_named_with_its_remedy(monkeypatch):
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    with pytest.raises(ModuleNotFoundError, match="environments need gymnasium, .* or pip install gymnasium"):
        register()
