"""The document of the maps."""

from collections.abc import Sequence

from f1tenth_studies.mapping.drive import Mapped
from f1tenth_studies.table import lines_of_table

_TITLE = "Maps"
_TEXT = """\
Drives by the driver of `create_map.launch`, one lap and on until 8 m beyond the next bend (by the true
poses), mapped by `gmapping_core` with the parameters of `f1tenth_gazebo/config/slam_gmapping.yaml`, without
ROS, and compared with the world as by `check_map`: share of the wall cells within 0.10 m of a true wall
(cells), and of the true walls within 0.10 m of a wall cell (walls). The distance between the estimated
and the true poses at the scans that count, RMS over a drive (error). Of several drives, the worst.

Wanted: 97 % both ways, on every drive. A map begins at the car's first pose, and a rotation of the map by a
thousandth of a radian there is 0.1 m a hundred metres away. So the same figures are given for the map aligned
with the world by a rotation and a shift of the whole (`check_map --align`): its shape.
"""
_HEADS = (
    "place",
    "lap (m)",
    "drives",
    "good",
    "cells (%)",
    "walls (%)",
    "error (m)",
    "seeds that failed",
    "turn (mrad)",
    "good in shape",
    "cells in shape (%)",
    "walls in shape (%)",
)


def document(mapped: Sequence[Mapped], made: str) -> str:
    """The whole document; `made`: how and where."""
    rows = [list(_HEADS), ["---"] * len(_HEADS)]
    for place in dict.fromkeys(each.drive.place for each in mapped):
        rows.append(_row(place, [each for each in mapped if each.drive.place == place]))
    good, shapes = sum(each.passed for each in mapped), sum(each.has_shape for each in mapped)
    said = f"{good} of {len(mapped)} drives are good enough, {shapes} in their shape."
    return f"# {_TITLE}\n\n{_TEXT}\n{made}\n{said}\n\n{lines_of_table(rows)}"


def _row(place: str, mapped: Sequence[Mapped]) -> list[str]:
    return [
        place,
        f"{max(each.lap for each in mapped):.0f}",
        str(len(mapped)),
        str(sum(each.passed for each in mapped)),
        f"{100 * min(each.check.cells_near_walls for each in mapped):.1f}",
        f"{100 * min(each.check.walls_near_cells for each in mapped):.1f}",
        f"{max(each.error for each in mapped):.3f}",
        ", ".join(str(each.drive.seed) for each in mapped if not each.passed) or "none",
        f"{1000 * max(abs(each.lies.turn) for each in mapped):.1f}",
        str(sum(each.has_shape for each in mapped)),
        f"{100 * min(each.shape.cells_near_walls for each in mapped):.1f}",
        f"{100 * min(each.shape.walls_near_cells for each in mapped):.1f}",
    ]
