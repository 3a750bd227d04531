"""A lidar that loses beams: what black paint, glass and a low sun do to a real one."""

import numpy as np


def drop_beams(ranges: np.ndarray, fraction: float, seed: int, stamp_ns: int) -> np.ndarray:
    """Replace a random choice of beams by +inf.

    Args:
        ranges: m, shape (n,)
        fraction: probability of each beam to be lost
        seed: of the choice; the same seed and stamp give the same choice
        stamp_ns: of the scan, ns
    """
    lost = np.random.default_rng((seed, stamp_ns)).random(len(ranges)) < fraction
    return np.where(lost, np.float32(np.inf), ranges)
