"""The document of being lost."""

import math
from collections.abc import Sequence

import numpy as np

from f1tenth_studies.drives.rms import rms
from f1tenth_studies.lost.trial import AFTERWARDS, ALIGNED, NEAR, Found, Told
from f1tenth_studies.table import lines_of_table

_TITLE = "Being lost"
_TEXT = f"""\
Drives by the driver of `create_map.launch` at 1.5 m/s, begun anywhere on a road, with the localizer of amcl
(`amcl_core`), its parameters in `f1tenth_navigation/config/amcl.yaml` and the noisy odometry of the wheels,
without ROS. amcl is told where the car is; or a pose that is off in any direction, with as large a standard
deviation, and the car drives towards a bend; or nothing (the service `global_localization`). The car
counts as found once amcl is right to {NEAR:g} m and {ALIGNED:g} rad and stays so until {AFTERWARDS:g} s after
the limit. From then on, the table has the distance from the true pose (error) and the standard deviation that
amcl reports (deviation), both in the plane and RMS over the drives of a row.

A drive in which the car was not found in time is checked again: from the last wrong place where amcl
believed the car to be, does everything that was seen along the way, until the limit, lie as near to walls of
the map as from the true place, to half a cell (RMS of each view)? Then nothing could tell where the car was.

Wanted: found within the limit, where that is possible; told the truth, always right, with a deviation of at
least half the error.
"""
_HEADS = (
    "place",
    "told",
    "drives",
    "limit (s)",
    "found",
    "could not be told",
    "slowest of them (s)",
    "seeds that failed",
    "error (m)",
    "deviation (m)",
)


def document(found: Sequence[Found], made: str) -> str:
    """The whole document; `made`: how and where."""
    rows = [list(_HEADS), ["---"] * len(_HEADS)]
    for told in Told:
        of_kind = [each for each in found if each.trial.told is told]
        for place in dict.fromkeys(each.trial.drive.place for each in of_kind):
            rows.append(_row(place, told, [each for each in of_kind if each.trial.drive.place == place]))
    in_time = sum(each.in_time for each in found)
    untold = sum(each.passed for each in found) - in_time
    said = f"In {in_time} of {len(found)} drives the car was found in time; in {untold} that was impossible."
    return f"# {_TITLE}\n\n{_TEXT}\n{made}\n{said}\n\n{lines_of_table(rows)}"


def _row(place: str, told: Told, found: Sequence[Found]) -> list[str]:
    in_time = [each for each in found if each.in_time]
    return [
        place,
        told.words,
        str(len(found)),
        f"{found[0].trial.limit:g}",
        str(len(in_time)),
        str(sum(each.passed for each in found) - len(in_time)),
        f"{max((each.after for each in in_time), default=math.inf):.2f}",
        ", ".join(str(each.trial.drive.seed) for each in found if not each.passed) or "none",
        f"{rms(np.concatenate([each.errors for each in found])):.3f}",
        f"{rms(np.concatenate([each.deviations for each in found])):.3f}",
    ]
