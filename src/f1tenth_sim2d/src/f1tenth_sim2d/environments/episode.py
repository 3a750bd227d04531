"""How an episode begins: where the cars start, and what is drawn at random for it."""

import numpy as np

import f1tenth_sim2d
from f1tenth_sim2d.environments.settings import require_number

OPTIONS = ("poses", "noise_seed")
"""Of reset."""
_ROW = 1.2  # m, from one row of the grid to the next
_ABREAST = 0.35  # m, from the line to either side, if there are several cars
_TRIES = 100  # to find a random start that is free
_HEADING = 0.2  # rad, at most, from the course at random starts
_HALF_CAR = 0.15  # m: a point that far beyond the width of the road is behind its wall


def begin_episode(environments, index, stage, rng, options):
    """Begin an episode of one environment.

    Args:
        environments: f1tenth_sim2d.Environments.
        index: of the environment.
        stage: Stage.
        rng: numpy.random.Generator, of all that is drawn.
        options: of Gymnasium's reset, both optional: {"poses": array of shape (cars, 3), x, y, yaw, m and
            rad; "noise_seed": int}.

    Raises:
        ValueError: unknown options, or a start that is not free or off the road. The environment is then as
            before.
    """
    options = _checked(options, stage)
    seed = options.get("noise_seed")
    drawn = int(rng.integers(2**63))
    parameters = [stage.draw_parameters(rng) for _ in range(stage.settings.cars)]
    noise = [draw(rng, stage.settings.lidar_noise) for _ in range(stage.settings.cars)]
    tries = 1 if "poses" in options or stage.settings.start == "grid" else _TRIES
    for remaining in reversed(range(tries)):
        poses = options.get("poses")
        starts = np.zeros((stage.settings.cars, 4))
        starts[:, :3] = _poses(stage, rng) if poses is None else poses
        try:
            environments.reset(index, drawn if seed is None else seed, parameters, starts, noise)
            return
        except f1tenth_sim2d.Error as error:
            if not remaining:
                raise ValueError(f"start: {error}") from error


def draw(rng, value):
    """Return a number, or draw it from (least, greatest)."""
    return float(rng.uniform(*value)) if isinstance(value, (tuple, list)) else float(value)


def _poses(stage, rng):
    return _random(stage, rng) if stage.settings.start == "random" else _grid(stage)


def _grid(stage):
    x, y, yaw = stage.place.world.start
    course = stage.place.course
    cars = stage.settings.cars
    poses = []
    for i in range(cars):
        back, offset = _ROW * (i // 2), 0.0 if cars == 1 else _ABREAST * (1 - 2 * (i % 2))
        if course is None or cars == 1:
            poses.append(
                (
                    x - back * np.cos(yaw) - offset * np.sin(yaw),
                    y - back * np.sin(yaw) + offset * np.cos(yaw),
                    yaw,
                )
            )
        else:
            poses.append(course.pose(course.locate(x, y)[0] - back, offset))
    return poses


def _random(stage, rng):
    """Far from each other, so that there is room however many cars there are."""
    course, cars = stage.place.course, stage.settings.cars
    first = rng.uniform(0.0, course.length)
    poses = []
    for i in range(cars):
        distance = first + course.length * i / cars
        room = max(0.0, stage.place.half_width(distance) - 0.4)
        x, y, yaw = course.pose(distance, rng.uniform(-room, room))
        poses.append((x, y, yaw + rng.uniform(-_HEADING, _HEADING)))
    return poses


def _checked(options, stage):
    options = dict(options or {})
    for key in options:
        if key not in OPTIONS:
            raise ValueError(f"options: unknown key {key!r}, allowed are {', '.join(OPTIONS)}")
    if "poses" in options:
        options["poses"] = _checked_poses(options["poses"], stage.settings.cars)
        if stage.place.course is not None:
            _require_road(options["poses"], stage.place)
    if options.get("noise_seed") is not None:
        require_number("options['noise_seed']", options["noise_seed"], 0, 2**63 - 1, int)
    return options


def _checked_poses(given, cars):
    try:
        poses = np.asarray(given, dtype=float)
    except (TypeError, ValueError) as error:
        raise ValueError(f"options['poses']: {error}; allowed are numbers of shape ({cars}, 3)") from error
    if poses.shape != (cars, 3) or not np.isfinite(poses).all():
        raise ValueError(
            f"options['poses']: found {given!r}, allowed are finite numbers of shape ({cars}, 3)"
        )
    return poses


def _require_road(poses, place):
    for index, (x, y, _) in enumerate(poses):
        distance, offset, _ = place.course.locate(x, y)
        side = "left" if offset > 0.0 else "right"
        width = place.width_to_the(side, distance)
        if abs(offset) > width + _HALF_CAR:
            raise ValueError(
                f"options['poses'][{index}]: found ({x:g}, {y:g}), {abs(offset):.2f} m to the {side} of the "
                f"course; allowed is up to {width:.2f} m, where the road ends"
            )
