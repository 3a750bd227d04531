"""Putting the page together: one HTML file with its style, scripts and data inside."""

import datetime
import hashlib
from pathlib import Path
from typing import Optional

from f1tenth_scenarios.atomic import replacing
from f1tenth_scenarios.errors import writing
from f1tenth_scenarios.report.content import RunContent, read_results
from f1tenth_scenarios.report.packing import pack

# In this order, because each uses those before it.
_SCRIPTS = (
    "format.js",
    "elements.js",
    "decode.js",
    "lidar.js",
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


def write_report(
    results: Path, output: Path, against: Optional[Path] = None, assets: Optional[Path] = None
) -> list[str]:
    """Write the report of a results folder, which replaces the old one when it is complete.

    Args:
        results: folder with one folder per scenario
        output: the HTML file
        against: as of read_results
        assets: folder of the style and the scripts; default: that of the package, which ROS finds

    Returns:
        What was found broken, one line each; the report shows it as well.

    Raises:
        ScenarioError: there is no run, or the report cannot be written.
    """
    runs = list(read_results(results, output.parent, against))
    head, tail = _template(runs, assets or _own_assets()).split("<!-- DATA -->")
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


def _world_id(run: RunContent) -> str:
    """Names the walls of a run; equal ones are kept only once."""
    return hashlib.sha256(run.world.encode()).hexdigest()[:12]


def _own_assets() -> Path:
    # Imported late, because it needs ROS.
    from f1tenth_scenarios import places

    return places.package_path(places.PACKAGE) / "report"


def _template(runs: list[RunContent], assets: Path) -> str:
    overview = {
        "created": datetime.datetime.now().astimezone().isoformat(timespec="minutes"),
        "runs": [{**run.summary, "world_id": _world_id(run)} for run in runs],
    }
    parts = {
        "<!-- STYLE -->": f"<style>\n{_read(assets / 'report.css')}</style>",
        "<!-- OVERVIEW -->": _data("overview", pack(overview)),
        "<!-- SCRIPTS -->": _scripts(assets),
    }
    text = _read(assets / "report.html")
    for mark, part in parts.items():
        text = text.replace(mark, part)
    return text


def _scripts(assets: Path) -> str:
    text = "\n".join(_read(assets / name) for name in _SCRIPTS)
    return f'<script>\n"use strict";\n(() => {{\n{text}}})();\n</script>'


def _data(name: str, packed: str) -> str:
    """Base64 in a script element that runs nothing."""
    return f'<script type="text/plain" id="{name}">{packed}</script>\n'


def _read(path: Path) -> str:
    return path.read_text(encoding="utf-8")
