"""Where a map lets a car through."""

from f1tenth_judge.places.map_file import FREE, UNKNOWN
from scipy import ndimage

HALF_CAR = 0.15
"""m, half of what a car needs between two walls"""


def is_passable(grid):
    """The cells that do not stop a car: free ones, and unknown ones of a patch that is narrower than a car.

    Drawn maps and those of SLAM have specks and slivers of unknown cells on the road: nothing was seen there.
    """
    cells = grid.cells
    unknown = cells == UNKNOWN
    reach = HALF_CAR / grid.resolution
    wide = ndimage.distance_transform_edt(unknown) > reach
    if not wide.any():
        return (cells == FREE) | unknown
    return (cells == FREE) | (unknown & (ndimage.distance_transform_edt(~wide) > reach))
