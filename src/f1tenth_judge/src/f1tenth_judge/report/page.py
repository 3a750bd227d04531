"""Putting the page together: one HTML file with its style, scripts and data inside."""

import datetime
import hashlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.atomic import replacing
from f1tenth_judge.errors import writing
from f1tenth_judge.report.bundle import bundle
from f1tenth_judge.report.content import RunContent, read_results
from f1tenth_judge.report.packing import pack

WEB = Path(__file__).parent / "web"  # the style and the scripts


def write_report(results: Path, output: Path, against: Optional[Path] = None) -> list[str]:
    """Write the report of a results folder, which replaces the old one when it is complete.

    Args:
        results: folder with one folder per scenario
        output: the HTML file
        against: as of read_results

    Returns:
        What was found broken, one line each; the report shows it as well.

    Raises:
        ScenarioError: there is no run, or the report cannot be written.
    """
    runs = list(read_results(results, output.parent, against))
    head, tail = _template(runs).split("<!-- DATA -->")
    worlds = {run.world: name for name, run in ((f"world-{_world_id(run)}", run) for run in runs)}
    with writing(output), replacing(output) as temporary, open(temporary, "w", encoding="utf-8") as stream:
        stream.write(head)
        for world, name in worlds.items():
            stream.write(_data(name, world))
        for index, run in enumerate(runs):
            stream.write(_data(f"replay-{index}", run.replay))
            if run.previous:
                stream.write(_data(f"previous-{index}", run.previous))
        stream.write(tail)
    return [problem for run in runs for problem in run.summary["problems"]]


def live_page(title: str, runs: Sequence[Mapping[str, Any]]) -> str:
    """The page of runs that go on; of each there is its `name`, and what else is known of it comes later."""
    unknown: dict[str, Any] = {"description": "", "cars": {}, "verdict": "", "criteria": [], "links": {}}
    summaries = [{**unknown, "scenario": run["name"], "problems": [], "live": True} for run in runs]
    return _filled({"title": title, "runs": summaries}).replace("<!-- DATA -->", "")


def _world_id(run: RunContent) -> str:
    """Names the walls of a run; equal ones are kept only once."""
    return hashlib.sha256(run.world.encode()).hexdigest()[:12]


def _template(runs: list[RunContent]) -> str:
    overview = {
        "created": datetime.datetime.now().astimezone().isoformat(timespec="minutes"),
        "runs": [{**run.summary, "world_id": _world_id(run)} for run in runs],
    }
    return _filled(overview)


def _filled(overview: Mapping[str, Any]) -> str:
    """The page without the data of its runs."""
    parts = {
        "<!-- STYLE -->": f"<style>\n{_read('report.css')}</style>",
        "<!-- OVERVIEW -->": _data("overview", pack(overview)),
        "<!-- SCRIPTS -->": _scripts(),
    }
    text = _read("report.html")
    for mark, part in parts.items():
        text = text.replace(mark, part)
    return text


def _scripts() -> str:
    return f'<script>\n"use strict";\n(() => {{\n{bundle(WEB / "app.js")}}})();\n</script>'


def _data(name: str, packed: str) -> str:
    """Base64 in a script element that runs nothing."""
    return f'<script type="text/plain" id="{name}">{packed}</script>\n'


def _read(name: str) -> str:
    return (WEB / name).read_text(encoding="utf-8")
