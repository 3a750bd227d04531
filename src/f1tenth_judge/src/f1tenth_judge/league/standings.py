"""Who is how good in a league."""

import dataclasses
import statistics
from collections.abc import Mapping
from typing import Any, Optional

from f1tenth_judge.league.league_file import League
from f1tenth_judge.league.races import Meeting

Results = Mapping[Meeting, Mapping[str, Any]]


@dataclasses.dataclass(frozen=True)
class Standing:
    """What one planner has achieved."""

    name: str
    raced: int
    finished: int  # of those: driven to the end without a touch
    pace: Optional[float]  # mean of its best laps over the best of all at the place; None without any lap
    won: int  # races against one other planner
    clearance: Optional[float]  # m, the least in a race of its own

    @property
    def order(self) -> tuple:
        """Standings are in this order: who finishes most, then who wins most, then who is fastest."""
        part = self.finished / self.raced if self.raced else 0.0
        return (-part, -self.won, self.pace if self.pace is not None else float("inf"), self.name)


def standings(league: League, results: Results) -> list[Standing]:
    """All planners, the best first."""
    return sorted((_standing(entry.name, results) for entry in league.planners), key=lambda each: each.order)


def best_lap(meeting: Meeting, result: Mapping[str, Any], name: str) -> Optional[float]:
    """Of a planner in a race, s."""
    car = list(result["cars"].values())[meeting.planners.index(name)]
    return min(car["lap_times"], default=None)


def _standing(name: str, results: Results) -> Standing:
    alone = {each: result for each, result in results.items() if each.planners == (name,)}
    laps, records = _laps(alone), _laps(results)
    near = (result["minimum_clearance"] for result in alone.values())
    return Standing(
        name,
        raced=len(alone),
        finished=sum(result["passed"] for result in alone.values()),
        pace=statistics.mean(lap / records[place] for place, lap in laps.items()) if laps else None,
        won=sum(_winner(each, result) == name for each, result in results.items()),
        clearance=min((each for each in near if each is not None), default=None),
    )


def _laps(results: Results) -> dict[str, float]:
    """The best lap of all who raced alone, s, by place."""
    laps: dict[str, float] = {}
    for each, result in results.items():
        lap = best_lap(each, result, each.planners[0]) if len(each.planners) == 1 else None
        if lap:
            laps[each.place] = min(lap, laps.get(each.place, lap))
    return laps


def _winner(meeting: Meeting, result: Mapping[str, Any]) -> Optional[str]:
    winner = result["winner"] and result["winner"]["car"]
    return meeting.planners[list(result["cars"]).index(winner)] if winner else None
