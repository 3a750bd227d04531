"""The page of a league: one HTML file without scripts, with links into the report beside it."""

from collections.abc import Iterator, Mapping, Sequence
from html import escape
from typing import Any

from f1tenth_judge.league.league_file import League
from f1tenth_judge.league.races import Meeting, meetings
from f1tenth_judge.league.standings import Results, Standing, best_lap
from f1tenth_judge.record.files import REPORT_FILE
from f1tenth_judge.report.tables import links, number, page, run_link, table, verdict

_PACE = (
    "Pace: the best lap divided by the best lap of all planners at the same place, averaged over the places."
)
_WON = " Won: races against another planner; the other columns are about races alone."


def league_page(
    title: str, league: League, ranking: Sequence[Standing], results: Results, left_out: Mapping
) -> str:
    """The ranking, and every race with its laps and a link to its replay."""
    won = ["won"] if league.pairs else []
    heads = ["", "planner", "finished", "pace", *won, "least clearance", "driver"]
    races = ["place", "seed", "planners", "verdict", "best laps", "reason"]
    missing = sum(each not in results for each in meetings(league))
    body = [
        *([f"<p>No result yet: {missing} of {len(list(meetings(league)))} races.</p>"] if missing else []),
        table(heads, _ranked(league, ranking)),
        f"<p>{_PACE}{_WON if league.pairs else ''}</p>",
        links([REPORT_FILE]),
        "<h2>Races</h2>",
        table(races, _raced(league, results, left_out)),
    ]
    return page(title, body)


def _ranked(league: League, ranking: Sequence[Standing]) -> Iterator[list[str]]:
    drivers = {entry.name: entry.driven_by for entry in league.planners}
    for rank, each in enumerate(ranking, 1):
        yield [
            str(rank),
            escape(each.name),
            f"{each.finished} of {each.raced}",
            number(each.pace),
            *([str(each.won)] if league.pairs else []),
            number(each.clearance, "m"),
            escape(drivers[each.name]),
        ]


def _raced(league: League, results: Results, left_out: Mapping[Meeting, str]) -> Iterator[list[str]]:
    for each in meetings(league):
        names = " against ".join(each.planners)
        row = [escape(each.place), str(each.seed)]
        if each in results:
            yield [*row, run_link(each.name, names), *_outcome(each, results[each])]
        else:
            why = left_out.get(each, "no result yet")
            yield [*row, escape(names), '<span class="none">not run</span>', "", escape(why)]


def _outcome(meeting: Meeting, result: Mapping[str, Any]) -> list[str]:
    laps = (number(best_lap(meeting, result, name), "s") for name in meeting.planners)
    return [verdict(result["verdict"], result["passed"]), ", ".join(laps), escape(result["reason"])]
