"""The map as a value: cells and where they lie."""

from dataclasses import dataclass

import numpy as np

# m, of an edge: what the six decimals of a file and the float32 of a message hold.
LEAST_RESOLUTION, MOST_RESOLUTION = 1e-6, 1e6


@dataclass(frozen=True)
class GridMap:
    """An occupancy grid: -1 unknown, 0 free ... 100 occupied."""

    cells: np.ndarray  # int8, [row, column], row 0 at the origin
    resolution: float  # m, edge length of a cell
    origin: tuple[float, float, float]  # x m, y m, yaw rad of the corner of cell (0, 0)

    @property
    def width(self):
        """Number of columns."""
        return self.cells.shape[1]

    @property
    def height(self):
        """Number of rows."""
        return self.cells.shape[0]
