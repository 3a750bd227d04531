"""Goals that are clicked one after the other; a click on one that is there takes it away again."""

import math
from typing import Any

REACH = 0.3
"""Within what distance of a goal a click counts as on it, m."""
CLEARANCE = 0.2
"""How much room a goal needs, m: a bit more than half the width of the car."""
_OCCUPIED = 50  # of a cell, from 0 to 100


class ClickedGoals:
    """Poses (with `x` and `y`, m) in order, and what is wrong with them on a map."""

    def __init__(self, poses=()):
        self.poses = list(poses)
        self._grid: Any = None

    def take(self, pose):
        """Take a click; returns whether a goal was added; if not, one was removed."""
        for place, known in enumerate(self.poses):
            if math.dist((pose.x, pose.y), (known.x, known.y)) < REACH:
                del self.poses[place]
                return False
        self.poses.append(pose)
        return True

    def take_map(self, grid):
        """Take the nav_msgs/OccupancyGrid that the goals are to lie on."""
        self._grid = grid

    def problems(self):
        """By number, from 1, why a goal cannot be reached; nothing while there is no map."""
        found = {number: self._problem(pose) for number, pose in enumerate(self.poses, 1)}
        return {number: text for number, text in found.items() if text}

    def _problem(self, pose):
        if self._grid is None:
            return ""
        if self._cell(pose.x, pose.y) is None:
            return "not on the map"
        angles = [index * math.pi / 8 for index in range(16)]
        around = [(pose.x + CLEARANCE * math.cos(a), pose.y + CLEARANCE * math.sin(a)) for a in angles]
        cells = [self._cell(*place) for place in [(pose.x, pose.y), *around]]
        if any(cell is not None and cell >= _OCCUPIED for cell in cells):
            return "in a wall"
        return "where the map is unknown" if cells[0] < 0 else ""

    def _cell(self, x, y):
        """The map's value at a place; None outside of the map. Maps are not rotated."""
        info = self._grid.info
        column = math.floor((x - info.origin.position.x) / info.resolution)
        row = math.floor((y - info.origin.position.y) / info.resolution)
        if not (0 <= column < info.width and 0 <= row < info.height):
            return None
        return self._grid.data[row * info.width + column]
