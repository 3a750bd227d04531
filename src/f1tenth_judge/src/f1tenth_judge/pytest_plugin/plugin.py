"""The plug-in of pytest: its option and setting, the fixture `f1tenth`, and what it says of runs."""

from collections.abc import Iterator
from pathlib import Path
from typing import Optional

import pytest

from f1tenth_judge.pytest_plugin import fixture
from f1tenth_judge.pytest_plugin.reporting import Reporting, note_runs

# pytest loads this module wherever the package is installed: what takes long is imported late.
f1tenth = fixture.f1tenth
_FOLDERS = "f1tenth_scenarios"  # the setting in pytest.ini


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add --planner, and the setting that names folders of scenarios."""
    text = "drives in scenarios and races of the fixture f1tenth: launch file, FILE.py:CLASS, or one of ours"
    parser.getgroup("f1tenth").addoption("--planner", metavar="PLANNER", help=text)
    parser.addini(_FOLDERS, "folders whose YAML files are scenarios, each an item", "paths", [])


def pytest_configure(config: pytest.Config) -> None:
    """Report where the runs are collected: not in the processes of xdist."""
    if not hasattr(config, "workerinput"):
        config.pluginmanager.register(Reporting(), "f1tenth_reporting")


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> Optional[pytest.Collector]:
    """A scenario file in one of the folders."""
    folder = next((each for each in parent.config.getini(_FOLDERS) if each in file_path.parents), None)
    if folder is None or file_path.suffix not in (".yaml", ".yml"):
        return None
    from f1tenth_judge.pytest_plugin.scenario_item import ScenarioFile

    name = "_".join(file_path.relative_to(folder).with_suffix("").parts)
    return ScenarioFile.from_parent(parent, path=file_path, run_name=name)


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Iterator[None]:
    """Say what the runs of a test came to."""
    outcome = yield
    note_runs(item, outcome.get_result())  # type: ignore[attr-defined]
