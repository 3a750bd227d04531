"""The page of a league: one HTML file without scripts, with links into the report beside it."""

from collections.abc import Iterator, Mapping, Sequence
from html import escape
from typing import Any
from urllib.parse import quote

from f1tenth_judge.league.league_file import League
from f1tenth_judge.league.races import Meeting, meetings
from f1tenth_judge.league.standings import Results, Standing, best_lap
from f1tenth_judge.record.files import REPORT_FILE

_STYLE = (
    "body{font:15px/1.5 system-ui,sans-serif;margin:2em auto;max-width:70em;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0}th,td{padding:.3em .8em;text-align:left}"
    "tr+tr{border-top:1px solid #ddd}td{font-variant-numeric:tabular-nums}"
    ".bad{color:#b3261e}.none{color:#777}"
)


def page(title: str, league: League, ranking: Sequence[Standing], results: Results, left_out: Mapping) -> str:
    """The ranking, and every race with its laps and a link to its replay."""
    body = [
        f"<h1>{escape(title)}</h1>",
        _table(["", "planner", "finished", "pace", "won", "least clearance"], _ranked(ranking)),
        "<p>Of races alone, except won. Pace: best laps over the best of all at the place, their mean.</p>",
        "<h2>Races</h2>",
        _table(
            ["place", "seed", "planners", "verdict", "best laps", "reason"], _raced(league, results, left_out)
        ),
    ]
    head = f'<meta charset="utf-8"><title>{escape(title)}</title><style>{_STYLE}</style>'
    return f'<!doctype html><html lang="en"><head>{head}</head><body>{"".join(body)}</body></html>\n'


def _ranked(ranking: Sequence[Standing]) -> Iterator[list[str]]:
    for rank, each in enumerate(ranking, 1):
        pace, clearance = (_number(value, unit) for value, unit in ((each.pace, ""), (each.clearance, " m")))
        yield [
            str(rank),
            escape(each.name),
            f"{each.finished} of {each.raced}",
            pace,
            str(each.won),
            clearance,
        ]


def _raced(league: League, results: Results, left_out: Mapping[Meeting, str]) -> Iterator[list[str]]:
    for each in meetings(league):
        names = " against ".join(each.planners)
        row = [escape(each.place), str(each.seed)]
        if each in results:
            yield [*row, _link(each, names), *_outcome(each, results[each])]
        else:
            why = left_out.get(each, "no result yet")
            yield [*row, escape(names), '<span class="none">not run</span>', "", escape(why)]


def _outcome(meeting: Meeting, result: Mapping[str, Any]) -> list[str]:
    laps = (_number(best_lap(meeting, result, name), " s") for name in meeting.planners)
    kind = "" if result["passed"] else ' class="bad"'
    return [f"<span{kind}>{escape(result['verdict'])}</span>", ", ".join(laps), escape(result["reason"])]


def _link(meeting: Meeting, text: str) -> str:
    return f'<a href="{REPORT_FILE}#{quote(meeting.name)}">{escape(text)}</a>'


def _number(value, unit: str) -> str:
    return "none" if value is None else f"{value:.3f}{unit}"


def _table(heads: Sequence[str], rows: Iterator[list[str]]) -> str:
    lines = [
        "".join(f"<th>{head}</th>" for head in heads),
        *("".join(f"<td>{cell}</td>" for cell in row) for row in rows),
    ]
    return "<table>" + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"
