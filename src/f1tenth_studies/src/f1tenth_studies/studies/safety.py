"""Inputs that fail on the road."""

import itertools

import numpy as np

from f1tenth_studies.study import CLEARANCE, CONTACTS, Column, Run, Study

BEGIN, END = 3.5, 6.5  # s, simulated; the car is on the first straight
DELAY = 0.5  # s, beyond every limit of age of the planner
STANDING = 0.05  # m/s
_FAULTS, _SPEED = "cars.robot1.input_faults", "cars.robot1.speed_max"


_TEXT = f"""\
An input of the planner is missing, or comes {DELAY:g} s late, from {BEGIN:g} to {END:g} s of simulated time:
the lidar (scan), the odometry (odom), the transforms (tf), alone and in pairs. The car is then on the first
straight of circuit5, at the greatest speed allowed (m/s), and is to finish its lap afterwards. Each run
is in lockstep, and so repeatable.

Without a map the action server is not up, and no goal is accepted (`interface.test` of move_base); stamps
that stand still or lie in the future are cases of its `move_base.test`, at 1.5 m/s.

Wanted: a standstill while inputs fail, the lap finished, no contact."""


def _values() -> str:
    names = ("scan", "odom", "tf")
    groups = [*itertools.combinations(names, 1), *itertools.combinations(names, 2)]
    return ",".join(
        f"[{{inputs: [{', '.join(group)}], at: {BEGIN:g}, until: {END:g}{delay}}}]"
        for delay in ("", f", delay: {DELAY:g}")
        for group in groups
    )


def speed_at_begin(run: Run) -> float:
    """How fast the car was when the fault began, m/s; nan if the run ended before."""
    track = run.record.tracks["robot1"]
    speeds = track.speed[track.time >= BEGIN]
    return float(speeds[0]) if len(speeds) else float("nan")


def stop_after(run: Run) -> float:
    """From the beginning of the fault until the car stood, s; infinite if it did not before the end."""
    track = run.record.tracks["robot1"]
    standing = track.time[(track.time >= BEGIN) & (track.time <= END) & (track.speed < STANDING)]
    return float(standing[0]) - BEGIN if len(standing) else float("inf")


def _defect(run: Run) -> str:
    return "" if np.isfinite(stop_after(run)) else "the car did not come to a stand"


STUDY = Study(
    title="Missing and late inputs",
    text=_TEXT,
    scenario="safety",
    vary={_FAULTS: _values(), _SPEED: "1,4,8"},
    rows=(_FAULTS, _SPEED),
    columns=(
        Column("speed at its beginning (m/s)", lambda runs: speed_at_begin(runs[0])),
        Column("stands after (s)", lambda runs: stop_after(runs[0])),
        CLEARANCE,
        CONTACTS,
    ),
    defect=_defect,
)
