"""The scene of a run: what stands in its world, cut at the height of the cars' lidars, and the cars."""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Optional

import f1tenth_sim2d
from f1tenth_judge.record.replay import Body, Lidar, Planar, Poses, Replay, Shape

_CUT_HEIGHT = 0.12  # m above the ground, where no lidar says otherwise


def load_scene(world: Path, descriptions: Mapping[str, str]) -> Replay:
    """Read a world, and the cars' robot_descriptions by name.

    Returns:
        The scene; an empty one if the world cannot be read, which the simulator has reported already.
    """
    # Reading a description takes long, and cars of a race have the same one.
    read = {text: _read(text) for text in set(descriptions.values())}
    cars = {name: car for name, text in descriptions.items() if (car := read[text])}
    try:
        return scene_of(f1tenth_sim2d.load_world(str(world)), cars)
    except f1tenth_sim2d.Error:
        return Replay()


def scene_of(world: f1tenth_sim2d.World, cars: Mapping[str, f1tenth_sim2d.Car]) -> Replay:
    """The scene of a loaded world and of loaded cars, by name."""
    lidars = {name: lidar for name, car in cars.items() if (lidar := lidar_of(car))}
    height = next((lidar.pose[2] for lidar in lidars.values()), _CUT_HEIGHT)
    return Replay(
        walls=_shape(*world.section(height)),
        models={model.name: _model(model, height) for model in world.models if not model.is_static},
        lidars={name: _described(lidar) for name, lidar in lidars.items()},
        bodies={name: _body(car) for name, car in cars.items()},
    )


def lidar_of(car: f1tenth_sim2d.Car) -> Optional[f1tenth_sim2d.Lidar]:
    """The one that drivers use: that on `scan`, else the first; nothing if the car has none."""
    return next((lidar for lidar in car.lidars if lidar.topic == "scan"), next(iter(car.lidars), None))


def _read(description):
    try:
        return f1tenth_sim2d.load_car(description, "car", "robot_description")
    except f1tenth_sim2d.Error:
        return None


def _body(car) -> Body:
    return (*car.extent, car.parameters.wheelbase, car.track_width)


def _described(lidar) -> Lidar:
    x, y, _, yaw = lidar.pose
    return lidar.angle_min, lidar.angle_max, x, y, yaw, lidar.range_max


def _model(model, height: float) -> Poses:
    return Poses([0.0], [model.pose], shape=_in_frame(_shape(*model.section(height)), model.pose))


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
