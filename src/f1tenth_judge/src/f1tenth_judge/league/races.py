"""The races of a league."""

import dataclasses
import itertools
from collections.abc import Iterator
from pathlib import Path

from f1tenth_judge.batch.sweep import Case
from f1tenth_judge.errors import NotApplicableError, writing
from f1tenth_judge.league.league_file import League
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.race import Race, plan_race, save_race
from f1tenth_judge.run.ros import require_runner
from f1tenth_judge.scenario.settings import Setting

_FILES = "races"  # folder of the scenario files


@dataclasses.dataclass(frozen=True)
class Meeting:
    """Who races where."""

    planners: tuple[str, ...]
    place: str
    seed: int

    @property
    def name(self) -> str:
        """Of its results."""
        where = Path(self.place).stem.removesuffix("_map")
        return "-".join([*self.planners, where, str(self.seed)])


def meetings(league: League) -> Iterator[Meeting]:
    """All races: of each planner alone, and of each pair where these are wanted."""
    names = [entry.name for entry in league.planners]
    groups: list[tuple[str, ...]] = [(name,) for name in names]
    groups += itertools.combinations(names, 2) if league.pairs else []
    for place, planners, seed in itertools.product(league.places, groups, league.seeds):
        yield Meeting(planners, place, seed)


def cases_of(league: League, beside: Path, folder: Path) -> tuple[dict[Meeting, Case], dict[Meeting, str]]:
    """Write the scenario files of all races to a folder.

    Args:
        league: whose races
        beside: folder of its file
        folder: of the results

    Returns:
        The races that can be run, and why others cannot.

    Raises:
        ScenarioError: a planner or place is not there, or a file cannot be written.
    """
    cases, left_out = {}, {}
    with writing(folder / _FILES):
        (folder / _FILES).mkdir(parents=True, exist_ok=True)
    for meeting in meetings(league):
        race = _race(league, meeting, beside)
        try:
            require_runner(plan_race(race, folder))
        except NotApplicableError as reason:
            left_out[meeting] = str(reason)
            continue
        file = folder / _FILES / f"{meeting.name}.yaml"
        save_race(race, file)
        cases[meeting] = Case(str(file), (Setting("seed", str(meeting.seed)),))
    return cases, left_out


def _race(league: League, meeting: Meeting, beside: Path) -> Race:
    place = meeting.place
    if lookup.is_path(place):
        place = str(lookup.file_at(place, beside))
    entries = (entry for entry in league.planners if entry.name in meeting.planners)
    return Race(place, league.laps, [entry.driver(beside) for entry in entries], called=meeting.name)
