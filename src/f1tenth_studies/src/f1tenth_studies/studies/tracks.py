"""Laps of others' tracks, in both directions."""

from pathlib import Path

from f1tenth_studies.made_places import track_names, track_worlds
from f1tenth_studies.study import CLEARANCE, CONTACTS, Column, Study, slowest

_KEY, _MODEL = "track", "model"


_TEXT = """\
Three laps from the standing start on tracks of the F1TENTH community (1:10) that were not used to develop the
planner, with default settings and perfect odometry, in both directions (`_reverse`), with both vehicle
models: `single_track`, whose tyres' forces grow with slip, and `single_track_drift`, whose tyres slide.

Wanted: every lap is driven, and nothing is touched."""


def _worlds(values: str, folder: Path) -> list[Path]:
    names = values.split(",") if values else track_names()
    return [world for name in names for world in track_worlds(name, folder)]


STUDY = Study(
    title="Tracks never seen",
    text=_TEXT,
    scenario="unseen_road",
    vary={_KEY: "", "laps": "3", _MODEL: "single_track,single_track_drift"},
    rows=(_KEY, _MODEL),
    columns=(
        Column("laps", lambda runs: sum(len(run.lap_times) for run in runs)),
        Column("slowest lap (s)", slowest),
        CLEARANCE,
        CONTACTS,
    ),
    places=(_KEY, _worlds),
)
