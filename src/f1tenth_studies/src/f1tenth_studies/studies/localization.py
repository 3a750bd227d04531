"""Laps with wheel odometry and amcl."""

import math

from f1tenth_scenarios.places import circuits

from f1tenth_studies.study import CLEARANCE, CONTACTS, Column, Study, slowest

_TEXT = """\
Laps with the noisy odometry of the wheels, corrected by amcl on the map (`localization:=amcl`), from the
standing start. The planner drives as in docs/race_pace.md, at race pace, but knows from amcl alone where it
is. A car that corners hard slides, which wheel odometry does not measure: within 0.1 s it may be wrong by
0.1 m to the side and by 0.2 rad. Errors are those of `amcl_pose` against the true pose, RMS over a run; of
the runs, each with its own seed, the worst counts.

Wanted: every goal passed without contact, at most 0.1 m and 3 degrees."""


STUDY = Study(
    title="Localization",
    text=_TEXT,
    scenario="localization",
    vary={"world": ",".join(circuits()), "seed": "1:3"},
    rows=("world",),
    columns=(
        Column("runs", len),
        Column("laps each", lambda runs: min(len(run.lap_times) for run in runs)),
        Column("slowest lap (s)", slowest),
        Column("error (m)", lambda runs: max(run.actual("localization_error") for run in runs)),
        Column(
            "error (deg)",
            lambda runs: math.degrees(max(run.actual("localization_yaw_error") for run in runs)),
            digits=2,
        ),
        CLEARANCE,
        CONTACTS,
    ),
    # The limits of the errors are criteria of the scenario.
    defect=lambda run: "" if run.result["passed"] else run.result["reason"],
)
