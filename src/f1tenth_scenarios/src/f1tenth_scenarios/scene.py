"""Putting the world around what was heard of a run."""

import contextlib
import dataclasses
import math
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import f1tenth_sim2d
from f1tenth_scenarios import places
from f1tenth_scenarios.recording import Recording
from f1tenth_scenarios.replay import Planar, Poses, Replay, Scans, Shape
from f1tenth_scenarios.scenario import Pose

_CUT_HEIGHT = 0.12  # m above the ground, where no lidar says otherwise


def make_replay(world: Path, goals: Mapping[str, Sequence[Pose]], heard: Recording) -> Replay:
    """The replay of a run; without walls if the world cannot be read, as the simulator has said already."""
    replay = Replay(
        goals={car: [(pose.x, pose.y, pose.yaw) for pose in poses] for car, poses in goals.items()},
        scans=heard.scans,
        global_plans=heard.global_plans,
        local_plans=heard.local_plans,
    )
    lidars = {car: lidar for car, text in heard.descriptions.items() if (lidar := _lidar(car, text))}
    height = next((lidar.pose[2] for lidar in lidars.values()), _CUT_HEIGHT)
    try:
        with _model_path():
            loaded = f1tenth_sim2d.load_world(str(world))
    except f1tenth_sim2d.Error:
        return replay
    return dataclasses.replace(
        replay,
        walls=_shape(*loaded.section(height)),
        scans={car: _mounted(scans, lidars.get(car)) for car, scans in heard.scans.items()},
        models=_models(loaded, heard.models, height),
    )


def _lidar(car, description):
    try:
        lidars = f1tenth_sim2d.load_car(description, car, car).lidars
    except f1tenth_sim2d.Error:
        return None
    return next((lidar for lidar in lidars if lidar.topic == "scan"), None)


def _mounted(scans: Scans, lidar) -> Scans:
    if lidar is None:
        return scans
    x, y, _, yaw = lidar.pose
    return dataclasses.replace(scans, mount=(x, y, yaw))


def _models(world, heard: Mapping[str, Poses], height: float) -> dict[str, Poses]:
    """The movable ones: where they were heard to be, else where the world has them."""
    return {
        model.name: dataclasses.replace(
            heard.get(model.name, Poses([0.0], [model.pose])),
            shape=_in_frame(_shape(*model.section(height)), model.pose),
        )
        for model in world.models
        if not model.is_static
    }


def _shape(outlines, circles) -> Shape:
    return Shape(
        [[(round(x, 3), round(y, 3)) for x, y in outline.tolist()] for outline in outlines],
        [tuple(round(value, 3) for value in circle) for circle in circles.tolist()],
    )


def _in_frame(shape: Shape, frame: Planar) -> Shape:
    """The same, seen from a frame (m, rad)."""
    cosine, sine = math.cos(frame[2]), math.sin(frame[2])

    def seen(x, y):
        dx, dy = x - frame[0], y - frame[1]
        return round(cosine * dx + sine * dy, 3), round(cosine * dy - sine * dx, 3)

    return Shape(
        [[seen(x, y) for x, y in outline] for outline in shape.outlines],
        [(*seen(x, y), radius) for x, y, radius in shape.circles],
    )


@contextlib.contextmanager
def _model_path() -> Iterator[None]:
    """Let models of the workspace be found, as simulator.launch does for the simulator."""
    before = os.environ.get("GAZEBO_MODEL_PATH", "")
    own = places.package_path(places.GAZEBO_PACKAGE) / "models"
    os.environ["GAZEBO_MODEL_PATH"] = f"{own}:{before}"
    try:
        yield
    finally:
        os.environ["GAZEBO_MODEL_PATH"] = before
