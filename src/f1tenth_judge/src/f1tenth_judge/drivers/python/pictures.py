"""What a planner sees through its cameras: drawn by the judge when it asks, left in memory that both have."""

import mmap
import os
from collections.abc import Sequence

import numpy as np

from f1tenth_judge.planner import Eye, Picture

_PIXEL = np.dtype(np.float32).itemsize + 3  # bytes of depth and colour


class PictureMemory:
    """Room for a picture of any of some eyes. Neither process waits until the other has taken it."""

    def __init__(self, descriptor: int, eyes: Sequence[Eye]):
        """Use the memory of `descriptor`, which both processes have."""
        os.ftruncate(descriptor, max((eye.width * eye.height * _PIXEL for eye in eyes), default=1))
        self._memory = mmap.mmap(descriptor, 0)

    def put(self, eye: Eye, picture: Picture) -> None:
        """Leave a picture."""
        there = self._picture(eye)
        there.colour[:], there.depth[:] = picture

    def take(self, eye: Eye) -> Picture:
        """A copy of the picture that was left."""
        return Picture(*(each.copy() for each in self._picture(eye)))

    def _picture(self, eye: Eye) -> Picture:
        shape = (eye.height, eye.width)
        depth = np.ndarray(shape, np.float32, self._memory)
        return Picture(np.ndarray((*shape, 3), np.uint8, self._memory, depth.nbytes), depth)
