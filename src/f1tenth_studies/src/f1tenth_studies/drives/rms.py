"""Root mean square."""

import math

import numpy as np


def rms(values: np.ndarray) -> float:
    """Of values of shape (n,); infinite without any."""
    return math.sqrt(float((values**2).mean())) if len(values) else math.inf
