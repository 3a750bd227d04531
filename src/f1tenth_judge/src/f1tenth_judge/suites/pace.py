"""Flying laps of the circuits and of others' tracks."""

from collections.abc import Mapping
from pathlib import Path

from f1tenth_judge.places.lookup import circuits
from f1tenth_judge.scenario.settings import Setting
from f1tenth_judge.suites.made_places import data_folder
from f1tenth_judge.suites.suite import Suite, with_models


def _cases(chosen: str, _: Path) -> Mapping[str, tuple[Setting, ...]]:
    tracks = () if chosen else map(str, sorted(data_folder().glob("*/*_map.yaml")))
    places = chosen.split(",") if chosen else [*circuits(), *tracks]
    return with_models({Path(place).stem.removesuffix("_map"): place for place in places})


SUITE = Suite(
    text="a lap from standstill and 20 flying, on circuits and $F1TENTH_DATA tracks; both vehicle models",
    scenario="pace",
    cases=_cases,
)
