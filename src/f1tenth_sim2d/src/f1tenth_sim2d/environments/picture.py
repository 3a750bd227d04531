"""A place and its cars, seen from above."""

import numpy as np
from PIL import ImageDraw, ImageFont

from f1tenth_sim2d.environments.ground import Ground
from f1tenth_sim2d.environments.place import Place

CARS = ((200, 55, 45), (40, 95, 175), (45, 140, 85), (210, 150, 30), (125, 75, 160), (60, 150, 160))
TRAIL = (236, 168, 160)
_BODY = np.array([(-0.1, -0.14), (0.43, -0.14), (0.43, 0.14), (-0.1, 0.14)])  # m, of a car
_NOSE = np.array([(0.2, -0.12), (0.41, 0.0), (0.2, 0.12)])  # m, tells the heading
_LEAST_LENGTH = 14.0  # pixels, of a car: a smaller one is drawn larger than it is
_INK, _BACK = (40, 42, 46), (255, 255, 255)
_TRAIL_STEP = 0.1  # m
_TRAIL_POINTS = 5000


class Picture:
    """Draws cars into a place; what is too large to be seen as a whole is shown around the first car."""

    def __init__(self, place: Place):
        self._ground = Ground(place)
        length = (_BODY[1, 0] - _BODY[0, 0]) * self._ground.scale
        self._enlarged = max(1.0, _LEAST_LENGTH / length)
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
        left, top = self._ground.corner(results[0]["x"], results[0]["y"])
        image = self._ground.image.crop((left, top, left + self.size[0], top + self.size[1]))
        draw = ImageDraw.Draw(image)

        def pixels(points):
            return [(x - left, y - top) for x, y in self._ground.pixels(points)]

        if len(self._trail) > 1:
            draw.line(pixels(np.array(self._trail)), fill=TRAIL, width=2)
        for i, car in reversed(list(enumerate(results))):
            draw.polygon(pixels(self._placed(_BODY, car)), fill=CARS[i % len(CARS)])
            draw.polygon(pixels(self._placed(_NOSE, car)), fill=_BACK)
        self._write(draw, results[0], time)
        return np.asarray(image)

    def _placed(self, corners, car):
        c, s = np.cos(car["yaw"]), np.sin(car["yaw"])
        return self._enlarged * corners @ np.array([[c, s], [-s, c]]) + (car["x"], car["y"])

    def _write(self, draw, car, time):
        speed = np.hypot(car["v_x"], car["v_y"])
        text = f"lap {int(car['laps']) + 1}   {time:.2f} s   {speed:.1f} m/s"
        box = draw.textbbox((8, 6), text, font=self._font)
        draw.rectangle((box[0] - 4, box[1] - 3, box[2] + 4, box[3] + 3), fill=_BACK)
        draw.text((8, 6), text, fill=_INK, font=self._font)
