"""Laps of two cars of ours against each other."""

from collections.abc import Mapping
from pathlib import Path

from f1tenth_studies.made_places import track_map, with_worlds
from f1tenth_studies.study import CLEARANCE, CONTACTS, Column, Study, place_of

_KEY = "track"


def _text() -> str:
    return """\
Five laps of tracks of the F1TENTH community by two cars of ours that start together, one 1.5 m behind the
other, with perfect odometry. Each knows from its lidar alone where the other is.

Wanted: both drive their laps, and nothing is touched."""


def _make(vary: Mapping[str, str], _: Path) -> dict[str, str]:
    """Gives the worlds of the tracks."""
    return with_worlds(vary, _KEY, map(track_map, vary[_KEY].split(",")))


def _laps(runs) -> str:
    times = [[len(car["lap_times"]) for car in run.result["cars"].values()] for run in runs]
    return " and ".join(str(sum(laps)) for laps in zip(*times))


def _slowest(runs) -> float:
    times = [time for run in runs for car in run.result["cars"].values() for time in car["lap_times"]]
    return max(times, default=float("inf"))


STUDY = Study(
    title="Two of ours",
    text=_text,
    scenario="rivals",
    vary={_KEY: "Oschersleben,Spielberg,Catalunya", "seed": "0:9"},
    rows=(_KEY,),
    columns=(
        Column("runs", len),
        Column("laps", _laps),
        Column("slowest lap (s)", _slowest),
        CLEARANCE,
        CONTACTS,
    ),
    problem=lambda run: run.failure(),
    make=_make,
    about=lambda values: {_KEY: place_of(values)},
)
