"""The commands that run a scenario many times: `scenario run --repeat` and `scenario sweep`."""

import itertools
import sys
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Optional

from f1tenth_scenarios.batch.batch import Job, run_job, summary_row
from f1tenth_scenarios.batch.repeat import is_steady, spread
from f1tenth_scenarios.batch.sweep import run_jobs
from f1tenth_scenarios.batch.sweep_table_file import check_table_file, write_table
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.results.console import CountLine
from f1tenth_scenarios.scenario.plan import make_plan
from f1tenth_scenarios.scenario.settings import Setting, combinations, folder_name, parse_variation

_TABLE_FILE, _PICTURE_FILE = "sweep.csv", "sweep.png"


def repeat(
    name: str, count: int, results: Path, settings: Sequence[str], program: str, jobs: int = 1
) -> bool:
    """Run a scenario `count` times, `jobs` at a time, and print how much the results differ.

    Returns:
        Whether all passed with the same verdict, and in lockstep with the same trajectory.

    Raises:
        ScenarioError: bad input, or a run left no result.
    """
    plan = make_plan(name, settings=settings)
    bar = CountLine(f"{plan.name} repeated", count)
    folders = [results / "repeat" / plan.name / f"{number:03}" for number in range(1, count + 1)]
    runs = [Job(str(plan.file), tuple(settings), str(folder)) for folder in folders]
    found = []
    try:
        with ThreadPoolExecutor(jobs) as pool:
            for result in pool.map(run_job, runs, itertools.repeat(program)):
                found.append(result)
                bar.update(result["passed"])
    except RuntimeError as error:
        raise ScenarioError(str(error)) from error
    bar.clear()
    for key, value in [("scenario", plan.name), *spread(found)]:
        print(f"{key + ':':19}{value}")
    return is_steady(found, plan.scenario.lockstep)


def sweep(
    name: str,
    variations: Sequence[str],
    results: Path,
    program: str,
    workers: Optional[int] = None,
    scheduler: Optional[str] = None,
    output: Optional[Path] = None,
) -> bool:
    """Run a scenario with every combination of values; write a table and a picture, and print where they are.

    Args:
        name: of the scenario, or its file
        variations: KEY=VALUES, as `parse_variation` reads them
        results: folder for all runs
        program: path of the command `scenario`
        workers: local processes; default: one a core
        scheduler: address of a Dask scheduler to use instead
        output: one more table, CSV or Parquet

    Returns:
        Whether every run left a result.

    Raises:
        ScenarioError: bad input; nothing has been run then.
    """
    if output:
        check_table_file(output)
    varied = [parse_variation(text) for text in variations]
    varied_keys = [values[0].key for values in varied]
    for key in varied_keys:
        if varied_keys.count(key) > 1:
            raise ScenarioError(f"--vary {key}: is varied more than once")
    jobs = [_job(name, settings, results) for settings in combinations(varied)]
    _check_folders(jobs)
    rows: dict[Job, dict[str, Any]] = {}
    bar = CountLine(f"{name} swept", len(jobs))

    def finished(job: Job, result: dict[str, Any]) -> None:
        rows[job] = summary_row(job.settings, result)
        bar.update(result["passed"])

    problems = run_jobs(jobs, program, finished, workers, scheduler)
    bar.clear()
    for problem in problems:
        print(f"scenario: {problem}", file=sys.stderr)
    if rows:
        ordered = [rows[job] for job in jobs if job in rows]
        folder = results / "sweep" / Path(jobs[0].scenario).stem
        tables = [folder / _TABLE_FILE, *([output] if output else [])]
        _write(folder, ordered, varied_keys, tables)
    return not problems


def _job(name: str, settings: Sequence[Setting], results: Path) -> Job:
    """Checks the variation before anything runs."""
    texts = tuple(map(str, settings))
    plan = make_plan(name, settings=texts)
    return Job(str(plan.file), texts, str(results / "sweep" / plan.name / folder_name(settings)))


def _check_folders(jobs: Sequence[Job]) -> None:
    """Values that differ only in characters that no folder's name can have would overwrite each other."""
    owners: dict[str, Job] = {}
    for job in jobs:
        owner = owners.setdefault(job.folder, job)
        if owner is not job:
            first, second = (" ".join(each.settings) for each in (owner, job))
            raise ScenarioError(f"'{first}' and '{second}' would both be written to {job.folder}")


def _write(folder, rows, varied, tables):
    # Imported late: matplotlib takes longer than everything else that the command does.
    from f1tenth_scenarios.batch.sweep_table import write_picture

    for table in tables:
        write_table(table, rows)
    write_picture(folder / _PICTURE_FILE, folder.name, rows, varied)
    facts = [
        ("scenario", folder.name),
        ("passed", f"{sum(row['passed'] for row in rows)} of {len(rows)}"),
        *(("table", table) for table in tables),
        ("picture", folder / _PICTURE_FILE),
    ]
    for key, value in facts:
        print(f"{key + ':':19}{value}")
