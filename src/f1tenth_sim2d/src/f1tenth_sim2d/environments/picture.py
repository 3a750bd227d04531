"""A place and its cars, seen from above."""

from typing import Optional

import numpy as np
from PIL import Image, ImageDraw

from f1tenth_sim2d.environments.place import Place

_SIZE = 800
"""Pixels of the longer side."""
_MARGIN = 0.5  # m
_HEIGHT = 0.16  # m, at which the world is cut
_BODY = np.array([(-0.1, -0.14), (0.43, -0.14), (0.43, 0.14), (-0.1, 0.14)])  # m, of a car
_PAPER, _WALL, _ROAD = (250, 250, 248), (70, 72, 78), (214, 216, 220)
_CARS = ((200, 55, 45), (40, 95, 175), (45, 140, 85), (210, 150, 30), (125, 75, 160), (60, 150, 160))


class Picture:
    """Draws cars into a place."""

    def __init__(self, place: Place):
        self._outlines, self._circles = place.world.section(_HEIGHT)
        points = np.concatenate([*self._outlines, self._circles[:, :2], [place.world.start[:2]]])
        self._low = points.min(axis=0) - _MARGIN
        extent = points.max(axis=0) + _MARGIN - self._low
        self._scale = _SIZE / extent.max()
        self._extent = np.maximum(1, np.ceil(extent * self._scale)).astype(int)
        self._ground = self._draw_ground(place)

    def draw(self, results) -> np.ndarray:
        """Return the picture, a uint8 array of shape (height, width, 3).

        Args:
            results: of the cars, structured array of shape (cars,).
        """
        image = self._ground.copy()
        draw = ImageDraw.Draw(image)
        for i, car in enumerate(results):
            c, s = np.cos(car["yaw"]), np.sin(car["yaw"])
            corners = _BODY @ np.array([[c, s], [-s, c]]) + (car["x"], car["y"])
            draw.polygon(self._pixels(corners), fill=_CARS[i % len(_CARS)])
        return np.asarray(image)

    def _draw_ground(self, place):
        image = Image.new("RGB", tuple(self._extent), _PAPER)
        draw = ImageDraw.Draw(image)
        if place.centreline is not None:
            line = self._pixels(np.concatenate([place.centreline[:, :2], place.centreline[:1, :2]]))
            draw.line(line, fill=_ROAD, width=2)
        for outline in self._outlines:
            draw.polygon(self._pixels(outline), fill=_WALL)
        for x, y, radius in self._circles:
            draw.ellipse(
                self._pixels(np.array([(x - radius, y + radius), (x + radius, y - radius)])), fill=_WALL
            )
        return image

    def _pixels(self, points):
        pixels = (points - self._low) * self._scale
        pixels[:, 1] = self._extent[1] - pixels[:, 1]
        return [tuple(point) for point in pixels]


class Window(Picture):
    """Shows the picture in a window."""

    def __init__(self, place: Place):
        """Open the window.

        Raises:
            gymnasium.error.DependencyNotInstalled: there is no pygame.
        """
        super().__init__(place)
        try:
            import pygame
        except ImportError as error:
            from gymnasium.error import DependencyNotInstalled

            raise DependencyNotInstalled("render_mode human needs pygame: pip install pygame") from error
        self._pygame = pygame
        pygame.display.init()
        pygame.display.set_caption(place.name)
        self._screen = pygame.display.set_mode(tuple(int(each) for each in self._extent))

    def draw(self, results):
        """Show the cars now."""
        image = super().draw(results)
        self._screen.blit(self._pygame.surfarray.make_surface(image.swapaxes(0, 1)), (0, 0))
        self._pygame.event.pump()
        self._pygame.display.flip()
        return image

    def close(self):
        """Close the window."""
        self._pygame.display.quit()


class View:
    """What an environment shows of itself: nothing, pictures, or a window."""

    MODES = ("rgb_array", "human")
    FRAMES_PER_SECOND = 40

    def __init__(self, mode: Optional[str], place: Place):
        """Draw nothing yet.

        Raises:
            ValueError: a render_mode other than None and those of MODES.
        """
        if mode not in (None, *self.MODES):
            raise ValueError(f"render_mode: found {mode!r}, allowed are None, {', '.join(self.MODES)}")
        self._mode, self._place = mode, place
        self._picture: Optional[Picture] = None

    def show(self, results) -> None:
        """Show the cars now, if there is a window; results as of Picture.draw."""
        if self._mode == "human":
            self._draw(results)

    def render(self, results) -> Optional[np.ndarray]:
        """Return the picture, see Picture.draw; None unless the mode is rgb_array."""
        return self._draw(results) if self._mode == "rgb_array" else None

    def close(self) -> None:
        """Close the window, if there is one; closing twice is allowed."""
        if isinstance(self._picture, Window):
            self._picture.close()
        self._picture = None

    def _draw(self, results):
        if self._picture is None:
            self._picture = (Window if self._mode == "human" else Picture)(self._place)
        return self._picture.draw(results)
