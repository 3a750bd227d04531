"""Laps of others' tracks, in both directions."""

from collections.abc import Mapping
from pathlib import Path

from f1tenth_studies.made_places import track_names, track_worlds, with_worlds
from f1tenth_studies.study import CLEARANCE, CONTACTS, Column, Study, place_of, slowest

_KEY, _MODEL = "track", "model"


def _text() -> str:
    return """\
Three laps from the standing start on tracks of the F1TENTH community (1:10) that the planner was not made on,
with default settings and perfect odometry, in both directions (`_reverse`), with both vehicle models:
`single_track`, whose tyres' forces grow with slip, and `single_track_drift`, whose tyres slide.

Wanted: every lap is driven, and nothing is touched."""


def _make(vary: Mapping[str, str], folder: Path) -> dict[str, str]:
    """Writes the tracks in both directions; gives the worlds."""
    names = vary[_KEY].split(",") if vary[_KEY] else track_names()
    worlds = [world for name in names for world in track_worlds(name, folder)]
    return with_worlds(vary, _KEY, worlds)


STUDY = Study(
    title="Tracks never seen",
    text=_text,
    scenario="unseen_road",
    vary={_KEY: "", "laps": "3", _MODEL: "single_track,single_track_drift"},
    rows=(_KEY, _MODEL),
    columns=(
        Column("laps", lambda runs: sum(len(run.lap_times) for run in runs)),
        Column("slowest lap (s)", slowest),
        CLEARANCE,
        CONTACTS,
    ),
    problem=lambda run: run.failure(),
    make=_make,
    about=lambda values: {_KEY: place_of(values)},
)
