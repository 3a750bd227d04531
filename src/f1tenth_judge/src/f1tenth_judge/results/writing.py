"""Writing down a run: the verdict first, then what may go wrong without costing it."""

from collections.abc import Mapping
from pathlib import Path
from typing import Callable

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.files import JUNIT_FILE, RESULT_FILE
from f1tenth_judge.results import versions
from f1tenth_judge.results.console import summary
from f1tenth_judge.results.junit import junit_of, write_junit
from f1tenth_judge.results.result import Result, as_dict
from f1tenth_judge.results.result_file import write_result


def write_verdict(plan: Plan, result: Result) -> None:
    """Write result.json and junit.xml into the folder of the result.

    Raises:
        ScenarioError: one of them cannot be written; the message has the verdict.
    """
    try:
        write_junit(result.folder / JUNIT_FILE, junit_of(result, summary(result, plan)))
        # Last, because a reader that sees a result.json may rely on it.
        found = versions.collect(plan.driver_folders)
        write_result(result.folder / RESULT_FILE, as_dict(result, found, plan.settings))
    except OSError as error:
        decision = result.judgement.decision
        raise ScenarioError(
            f"{result.folder}: the results cannot be written: {error.strerror};"
            f" the verdict was {decision.verdict.value}: {result.reason}"
        ) from error


def write_rest(folder: Path, files: Mapping[str, Callable[[Path], None]]) -> tuple[str, ...]:
    """Write files by name; what goes wrong with one does not keep the others from being written.

    Returns:
        Each file that was not written, with the reason.
    """
    problems = []
    for name, write in files.items():
        try:
            write(folder / name)
        except Exception as error:  # whatever it is, memory included
            problems.append(f"{name}: {_reason(error)}")
    return tuple(problems)


def _reason(error: Exception) -> str:
    if isinstance(error, ScenarioError):
        return str(error)
    return getattr(error, "strerror", None) or f"{type(error).__name__} {error}".strip()
