"""Samples on the surface of what stands in a world, and the directions away from it."""

import numpy as np

_STEP = 0.02
"""Between samples, m."""


def along(outline):
    """Samples along a closed outline that has its solid on the left, and the directions away from it."""
    samples, normals = [], []
    for a, b in zip(outline, np.roll(outline, -1, axis=0)):
        length = np.linalg.norm(b - a)
        count = max(1, int(length / _STEP))
        samples.append(a + np.linspace(0.0, 1.0, count, endpoint=False)[:, np.newaxis] * (b - a))
        normals.append(np.tile(np.array([b[1] - a[1], a[0] - b[0]]) / length, (count, 1)))
    return np.concatenate(samples), np.concatenate(normals)


def around(x, y, radius):
    """The same around a circle (m)."""
    angles = np.linspace(0.0, 2.0 * np.pi, max(8, int(2.0 * np.pi * radius / _STEP)))
    normals = np.column_stack([np.cos(angles), np.sin(angles)])
    return np.array([x, y]) + radius * normals, normals
