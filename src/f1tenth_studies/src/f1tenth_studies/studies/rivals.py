"""Laps of two cars of ours against each other."""

from f1tenth_studies.made_places import track_map
from f1tenth_studies.study import CLEARANCE, CONTACTS, Column, Study

_KEY = "track"


_TEXT = """\
Five laps of tracks of the F1TENTH community by two cars with our planner that start together, one 1.5 m
behind the other, with perfect odometry. Each knows from its lidar alone where the other is.

Wanted: both drive their laps, and nothing is touched."""


def _laps(runs) -> str:
    times = [[len(car["lap_times"]) for car in run.result["cars"].values()] for run in runs]
    return " and ".join(str(sum(laps)) for laps in zip(*times))


def _slowest(runs) -> float:
    times = [time for run in runs for car in run.result["cars"].values() for time in car["lap_times"]]
    return max(times, default=float("inf"))


STUDY = Study(
    title="Two of ours",
    text=_TEXT,
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
    places=(_KEY, lambda values, _: map(track_map, values.split(","))),
)
