"""A place and its cars, seen from above."""

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from f1tenth_sim2d.environments.ground import Ground

CARS = ((47, 91, 234), (224, 88, 43), (18, 149, 122), (147, 51, 234))
"""As in report.css."""
TRAIL = (160, 178, 245)
_BODY = np.array([(-0.1, -0.14), (0.43, -0.14), (0.43, 0.14), (-0.1, 0.14)])  # m, of a car
_NOSE = np.array([(0.2, -0.12), (0.41, 0.0), (0.2, 0.12)])  # m, tells the heading
_LEAST_LENGTH = 14.0  # pixels, of a car: a smaller one is drawn larger than it is
_INK, BACK = (40, 42, 46), (255, 255, 255)
_TRAIL_STEP = 0.1  # m
_TRAIL_POINTS = 5000


def draw_moment(ground: Ground, poses, trails) -> Image.Image:
    """Cars at their places; what is too large to be seen as a whole is shown around the first one.

    Args:
        ground: beneath them.
        poses: x, y (m) and yaw (rad) of each.
        trails: pairs of a colour and an array of points, m, of shape (n, 2).
    """
    corner = ground.corner(*poses[0][:2])
    image = ground.image.crop((*corner, *(at + size for at, size in zip(corner, ground.view))))
    draw = ImageDraw.Draw(image)
    enlarged = max(1.0, _LEAST_LENGTH / ((_BODY[1, 0] - _BODY[0, 0]) * ground.scale))

    def pixels(points):
        return [(x - corner[0], y - corner[1]) for x, y in ground.pixels(points)]

    for colour, points in trails:
        if len(points) > 1:
            draw.line(pixels(points), fill=colour, width=2)
    for i, pose in reversed(list(enumerate(poses))):
        draw.polygon(pixels(_placed(enlarged * _BODY, pose)), fill=CARS[i % len(CARS)])
        draw.polygon(pixels(_placed(enlarged * _NOSE, pose)), fill=BACK)
    return image


def _placed(corners, pose):
    x, y, yaw = pose
    c, s = np.cos(yaw), np.sin(yaw)
    return corners @ np.array([[c, s], [-s, c]]) + (x, y)


class Picture:
    """Draws the cars of an environment, and the trail of the first one."""

    def __init__(self, ground: Ground):
        self._ground = ground
        self._font = ImageFont.load_default()
        self._trail: list = []
        self._time = np.inf

    @property
    def size(self):
        """(width, height), pixels."""
        return self._ground.view

    def note(self, car, time):
        """Add to the trail where the first car is; a time that goes back (s) begins a new trail."""
        if time < self._time:
            self._trail = []
        self._time = time
        here = (float(car["x"]), float(car["y"]))
        if not self._trail or np.hypot(*np.subtract(here, self._trail[-1])) >= _TRAIL_STEP:
            self._trail = [*self._trail[-_TRAIL_POINTS:], here]

    def draw(self, results, time) -> np.ndarray:
        """Return the picture, a uint8 array of shape (height, width, 3).

        Args:
            results: of the cars, structured array of shape (cars,).
            time: simulated, s.
        """
        poses = [(car["x"], car["y"], car["yaw"]) for car in results]
        image = draw_moment(self._ground, poses, [(TRAIL, np.array(self._trail))])
        self._write(ImageDraw.Draw(image), results[0], time)
        return np.asarray(image)

    def _write(self, draw, car, time):
        speed = np.hypot(car["v_x"], car["v_y"])
        text = f"lap {int(car['laps']) + 1}   {time:.2f} s   {speed:.1f} m/s"
        box = draw.textbbox((8, 6), text, font=self._font)
        draw.rectangle((box[0] - 4, box[1] - 3, box[2] + 4, box[3] + 3), fill=BACK)
        draw.text((8, 6), text, fill=_INK, font=self._font)
