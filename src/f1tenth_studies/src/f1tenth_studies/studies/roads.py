"""Laps of random roads."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from f1tenth_judge.places.course import read_course

from f1tenth_studies.made_places import road_world, seeds
from f1tenth_studies.study import CLEARANCE, CONTACTS, Column, Study, failed_places, slowest

_KEY, _MODEL = "road", "model"
_SHORT, _LONG = 80.0, 200.0  # m
_NARROW, _WIDE = 1.6, 2.4  # m


_TEXT = f"""\
One lap from the standing start on roads of `rosrun f1tenth_gazebo make_road --seed N`, with default settings
and perfect odometry, with both vehicle models: `single_track`, whose tyres' forces grow with slip, and
`single_track_drift`, whose tyres slide. Their kinds: short (up to {_SHORT:g} m), middle (up to {_LONG:g} m)
and long; narrow (up to {_NARROW:g} m at the narrowest place), middle (up to {_WIDE:g} m) and wide.

Wanted: every lap is driven, and nothing is touched."""


def _kind(values: Mapping[str, str]) -> dict[str, str]:
    course = read_course(Path(values["world"].removesuffix(".world") + "_centerline.csv"))
    width = float(np.min(course.right + course.left))
    lengths = ("short", "middle", "long")[int(np.digitize(course.length, (_SHORT, _LONG)))]
    widths = ("narrow", "middle", "wide")[int(np.digitize(width, (_NARROW, _WIDE)))]
    return {"length": lengths, "width": widths}


STUDY = Study(
    title="Roads never seen",
    text=_TEXT,
    scenario="unseen_road",
    vary={_KEY: "0:199", _MODEL: "single_track,single_track_drift"},
    rows=("length", "width", _MODEL),
    columns=(
        Column("laps", len),
        Column("failed", lambda runs: sum(bool(run.failure()) for run in runs)),
        Column("which", failed_places),
        Column("slowest lap (s)", slowest),
        CLEARANCE,
        CONTACTS,
    ),
    places=(_KEY, lambda values, folder: [road_world(seed, folder) for seed in seeds(_KEY, values)]),
    labels=_kind,
)
