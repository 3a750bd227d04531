"""Putting the page together: one HTML file with its style, scripts and data inside."""

import datetime
import json
from pathlib import Path
from typing import Any, Optional

from f1tenth_scenarios import places
from f1tenth_scenarios.atomic import replacing
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.report.content import RunContent, read_results

REPORT_FILE = "report.html"
# In this order, because each uses what stands before it.
_SCRIPTS = (
    "format.js",
    "elements.js",
    "decode.js",
    "run.js",
    "player.js",
    "viewport.js",
    "painter.js",
    "view.js",
    "chart.js",
    "facts.js",
    "keyboard.js",
    "run_page.js",
    "overview.js",
    "app.js",
)


def write_report(results: Path, output: Path, against: Optional[Path] = None) -> int:
    """Write the report of a results folder, which replaces the old one when it is complete.

    Args:
        results: folder with a folder a scenario
        output: the HTML file
        against: another results folder to compare with; default: the run before, which each folder keeps

    Returns:
        The number of runs in it.

    Raises:
        ScenarioError: there is no run, a file is broken, or the report cannot be written.
    """
    runs = list(read_results(results, against))
    head, tail = _template(runs).split("<!-- DATA -->")
    try:
        with replacing(output) as temporary, open(temporary, "w", encoding="utf-8") as stream:
            stream.write(head)
            for index, run in enumerate(runs):
                stream.write(_data(f"replay-{index}", run.replay.as_dict()))
                if run.previous:
                    stream.write(_data(f"previous-{index}", run.previous.as_dict()))
            stream.write(tail)
    except OSError as error:
        raise ScenarioError(f"{output}: cannot be written: {error.strerror}") from error
    return len(runs)


def _template(runs: list[RunContent]) -> str:
    assets = places.package_path(places.PACKAGE) / "report"
    overview = {
        "created": datetime.datetime.now().astimezone().isoformat(timespec="minutes"),
        "runs": [run.summary for run in runs],
    }
    parts = {
        "<!-- STYLE -->": f"<style>\n{_read(assets / 'report.css')}</style>",
        "<!-- OVERVIEW -->": _data("overview", overview),
        "<!-- SCRIPTS -->": _scripts(assets),
    }
    text = _read(assets / "report.html")
    for mark, part in parts.items():
        text = text.replace(mark, part)
    return text


def _scripts(assets: Path) -> str:
    text = "\n".join(_read(assets / name) for name in _SCRIPTS)
    return f'<script>\n"use strict";\n(() => {{\n{text}}})();\n</script>'


def _data(name: str, content: Any) -> str:
    """JSON in a script element that runs nothing; no text in it can end the element."""
    text = json.dumps(content, separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
    return f'<script type="application/json" id="{name}">{text}</script>\n'


def _read(path: Path) -> str:
    return path.read_text(encoding="utf-8")
