"""The document of the maps."""

from collections.abc import Sequence

from f1tenth_studies.mapping.drive import Mapped

_TITLE = "Maps"
_TEXT = """\
Drives of the driver of `create_map.launch`, a lap and until 8 m behind the next bend (told by the true
poses), mapped by `gmapping_core` with the parameters of `f1tenth_gazebo/config/slam_gmapping.yaml`, without
ROS, and compared with the world as by `check_map`: share of the wall cells within 0.10 m of a true wall
(cells), and of the true walls within 0.10 m of a wall cell (walls). Of the poses at the scans that count,
the distance from the true ones, RMS over a drive (error). Of several drives, the worst.

Wanted: 97 % both ways, on every drive.
"""
_HEADS = ("place", "lap (m)", "drives", "good", "cells (%)", "walls (%)", "error (m)", "seeds that failed")


def document(mapped: Sequence[Mapped], made: str) -> str:
    """The whole document.

    Args:
        mapped: at least one
        made: how and where the table was made
    """
    rows = [list(_HEADS), ["---"] * len(_HEADS)]
    for place in dict.fromkeys(each.drive.place for each in mapped):
        rows.append(_row(place, [each for each in mapped if each.drive.place == place]))
    table = "".join(f"| {' | '.join(row)} |\n" for row in rows)
    good = sum(each.passed for each in mapped)
    return f"# {_TITLE}\n\n{_TEXT}\n{made}\n{good} of {len(mapped)} drives are good enough.\n\n{table}"


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
    ]
