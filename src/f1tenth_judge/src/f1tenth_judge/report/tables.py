"""Pages of tables: HTML without scripts, with links into the report beside them."""

from collections.abc import Iterable, Iterator, Sequence
from html import escape
from urllib.parse import quote

from f1tenth_judge.record.files import REPORT_FILE

_STYLE = (
    "body{font:15px/1.5 system-ui,sans-serif;margin:2em auto;max-width:70em;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0;display:block;overflow-x:auto}"
    "th,td{padding:.3em .8em;text-align:left;white-space:nowrap}"
    "tr+tr{border-top:1px solid #ddd}td{font-variant-numeric:tabular-nums}"
    "td:last-child{white-space:normal;min-width:12em}"
    ".bad{color:#b3261e}.none{color:#777}"
)


def page(title: str, body: Sequence[str]) -> str:
    """A page with its title as heading above the body, which is HTML."""
    small = '<meta name="viewport" content="width=device-width">'
    head = f'<meta charset="utf-8">{small}<title>{escape(title)}</title><style>{_STYLE}</style>'
    content = f"<h1>{escape(title)}</h1>{''.join(body)}"
    return f'<!doctype html><html lang="en"><head>{head}</head><body>{content}</body></html>\n'


def table(heads: Iterable[str], rows: Iterator[Sequence[str]]) -> str:
    """A table; cells are HTML."""
    lines = [
        "".join(f"<th>{head}</th>" for head in heads),
        *("".join(f"<td>{cell}</td>" for cell in row) for row in rows),
    ]
    return "<table>" + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"


def links(files: Iterable[str]) -> str:
    """Links to files beside the page."""
    return "<p>" + ", ".join(f'<a href="{quote(each)}">{escape(each)}</a>' for each in files) + "</p>"


def run_link(name: str, text: str) -> str:
    """A link to the replay of a run, by the name of its folder."""
    return f'<a href="{REPORT_FILE}#{quote(name)}">{escape(text)}</a>'


def verdict(verdict: str, passed: bool) -> str:
    """A verdict, red if it is no pass."""
    kind = "" if passed else ' class="bad"'
    return f"<span{kind}>{escape(verdict)}</span>"


def number(value: float | None, unit: str = "") -> str:
    """A number with its unit."""
    return "none" if value is None else f"{value:.3f} {unit}".rstrip()
