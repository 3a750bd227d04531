"""What an environment shows of itself."""

import os
from typing import Optional

import numpy as np

from f1tenth_sim2d.environments.ground import Ground
from f1tenth_sim2d.environments.picture import Picture


class Window(Picture):
    """Shows the picture in a window, until somebody closes that."""

    def __init__(self, place):
        """Open the window.

        Raises:
            gymnasium.error.DependencyNotInstalled: there is no pygame.
        """
        super().__init__(Ground.of(place))
        try:
            import pygame
        except ImportError as error:
            from gymnasium.error import DependencyNotInstalled

            raise DependencyNotInstalled("render_mode human needs pygame: pip install pygame") from error
        self._pygame = pygame
        os.environ.setdefault("SDL_NO_SIGNAL_HANDLERS", "1")  # or SIGTERM would be an event that ends nothing
        pygame.display.init()
        pygame.display.set_caption(place.name)
        self._screen = pygame.display.set_mode(self.size)

    def draw(self, results, time):
        """Show the cars now; nothing once the window is closed."""
        if any(event.type == self._pygame.QUIT for event in self._events()):
            self.close()
        if not self._pygame.display.get_init():
            return None
        image = super().draw(results, time)
        self._screen.blit(self._pygame.surfarray.make_surface(image.swapaxes(0, 1)), (0, 0))
        self._pygame.display.flip()
        return image

    def close(self):
        """Close the window."""
        self._pygame.display.quit()

    def _events(self):
        return self._pygame.event.get() if self._pygame.display.get_init() else ()


class View:
    """The first environment of a stage: nothing, pictures, or a window."""

    MODES = ("rgb_array", "human")
    FRAMES_PER_SECOND = 40

    def __init__(self, mode: Optional[str], stage):
        """Draw nothing yet.

        Raises:
            ValueError: a render_mode other than None and those of MODES.
        """
        if mode not in (None, *self.MODES):
            raise ValueError(f"render_mode: found {mode!r}, allowed are None, {', '.join(self.MODES)}")
        self._mode, self._stage = mode, stage
        self._picture: Optional[Picture] = None

    def show(self) -> None:
        """Take notice of where the cars are now, and show them if there is a window."""
        if self._mode is not None:
            self._opened().note(self._stage.results[0][0], float(self._stage.times[0]))
        if self._mode == "human":
            self._draw()

    def render(self) -> Optional[np.ndarray]:
        """Return the picture, see Picture.draw; None unless the mode is rgb_array."""
        return self._draw() if self._mode == "rgb_array" else None

    def close(self) -> None:
        """Close the window, if there is one; closing twice is allowed."""
        if isinstance(self._picture, Window):
            self._picture.close()
        self._picture = None

    def _opened(self):
        if self._picture is None:
            place = self._stage.place
            self._picture = Window(place) if self._mode == "human" else Picture(Ground.of(place))
        return self._picture

    def _draw(self):
        return self._opened().draw(self._stage.results[0], float(self._stage.times[0]))
