"""What the environments that can be seen and recorded have in common."""

from f1tenth_sim2d.environments.car import numbered
from f1tenth_sim2d.environments.recording import recorder_into, watch_of
from f1tenth_sim2d.environments.stage import Stage
from f1tenth_sim2d.environments.view import View


class ShownEnv:
    """One simulation, shown and recorded as asked for."""

    def __init__(self, render_mode, record, watch, settings, names=numbered):
        self.render_mode = render_mode
        self._stage = Stage(settings, names=names)
        self._view = View(render_mode, self._stage)
        self._recorder = recorder_into(record, self._stage)
        self._watch = watch_of(watch, self._stage)
        self._closed = False

    def __getstate__(self):
        """For copy and pickle.

        Raises:
            TypeError: it is recorded, watched or shown in a window, which two cannot share.
        """
        if self._recorder or self._watch or self.render_mode == "human":
            raise TypeError(
                "an environment that is recorded, watched or in a window cannot be copied or pickled"
            )
        return self.__dict__

    def render(self):
        """Return the picture from above: uint8 array of shape (height, width, 3); None unless rgb_array."""
        self._require_open()
        return self._view.render()

    def close(self):
        """Release everything; closing twice is allowed."""
        self._view.close()
        if self._recorder and not self._closed:
            self._recorder.close()
        if self._watch and not self._closed:
            self._watch.close()
        self._closed = True

    def _begin(self, rng, options):
        self._stage.begin(0, rng, options)
        self._view.show()
        if self._recorder:
            self._recorder.begin()
        if self._watch:
            self._watch.begin()

    def _show(self):
        """Show a step."""
        self._view.show()
        if self._watch:
            self._watch.note()

    def _require_open(self):
        if self._closed:
            raise ValueError("the environment is closed")
