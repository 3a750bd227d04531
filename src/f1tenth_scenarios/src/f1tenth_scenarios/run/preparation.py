"""What the results need and what takes long to prepare, but does not depend on how a run ends."""

import importlib
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Callable

from f1tenth_scenarios.run.supervisor import Progress

if TYPE_CHECKING:
    from f1tenth_judge.record.replay import Replay


class Preparation:
    """Works beside a run as soon as the simulation has begun, when nobody waits for it."""

    def __init__(self, world: Path, descriptions: Callable[[], Mapping[str, str]]):
        """`world` is simulated, `descriptions` gives the robot_description of each car once it runs.

        The latter is called in a thread: a master that does not answer must not cost the verdict.
        """
        self._world = world
        self._descriptions = descriptions
        self._pool = ThreadPoolExecutor(1, "preparation")
        self._begun = False

    def beside(self, progress: Progress) -> Progress:
        """The same callback, which also notices when the simulation has begun."""

        def report(simulated, wall):
            if simulated is not None:
                self.begin()
            progress(simulated, wall)

        return report

    def begin(self) -> None:
        """Begin, at the latest now."""
        if self._begun:
            return
        self._begun = True
        self._picture = self._pool.submit(importlib.import_module, "f1tenth_judge.results.picture")
        self._scene = self._pool.submit(_load_scene, self._world, self._descriptions)
        self._pool.shutdown(wait=False)

    def picture(self):
        """The module that draws, which imports matplotlib."""
        return self._picture.result()

    def scene(self) -> "Replay":
        """What the replay shows around the cars."""
        return self._scene.result()


def _load_scene(world, descriptions):
    from f1tenth_judge.record.scene import load_scene

    return load_scene(world, descriptions())
