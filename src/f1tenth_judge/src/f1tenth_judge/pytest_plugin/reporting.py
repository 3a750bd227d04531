"""What is said of runs: in a test that fails, in JUnit files, and in the report of all results."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from f1tenth_judge.api.run import Run

RUNS: "pytest.StashKey[list[Run]]" = pytest.StashKey()
_PROPERTY = "f1tenth_results"  # of a test in a JUnit file: the folder of a run


def note_runs(item: pytest.Item, report: pytest.TestReport) -> None:
    """Put the runs of a test into its report."""
    if report.when != "call":
        return
    for run in item.stash.get(RUNS, []):
        item.user_properties.append((_PROPERTY, str(run.folder)))
        if report.failed:
            report.sections.append((f"f1tenth {run.folder.name}", str(run)))


class Reporting:
    """Collects where runs have left results, and writes a report on them at the end."""

    def __init__(self) -> None:
        self._folders: set[Path] = set()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Take what a process of xdist, or this one, tells of a test."""
        runs = (value for name, value in report.user_properties if name == _PROPERTY)
        self._folders |= {Path(str(value)).parent for value in runs}

    def pytest_terminal_summary(self, terminalreporter: Any) -> None:
        """Write the reports, and say where they are."""
        for folder in sorted(self._folders):
            from f1tenth_judge.record.files import REPORT_FILE
            from f1tenth_judge.report.page import write_report

            for problem in write_report(folder, folder / REPORT_FILE):
                terminalreporter.write_line(problem)
            terminalreporter.write_line(f"f1tenth report: {folder / REPORT_FILE}")
