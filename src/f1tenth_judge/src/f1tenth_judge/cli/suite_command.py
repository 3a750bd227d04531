"""f1tenth suite."""

import functools
import importlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from f1tenth_judge import suites
from f1tenth_judge.atomic import replacing
from f1tenth_judge.batch.jobs import Job
from f1tenth_judge.batch.table_file import check_table_file, write_table
from f1tenth_judge.cli.exit_codes import NOT_PASSED, PASSED
from f1tenth_judge.cli.many import check_many, run_many
from f1tenth_judge.cli.options import planner_of, planner_settings, results_of, seed_settings
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.extensions import extensions
from f1tenth_judge.plan.planner import PLANNER, driver_text
from f1tenth_judge.record.files import JUNIT_FILE, PAGE_FILE, REPORT_FILE
from f1tenth_judge.results.reference_laps import reference_of
from f1tenth_judge.results.standing import planner_text
from f1tenth_judge.scenario.settings import parse_setting
from f1tenth_judge.suites.suite import Suite

_TABLE_FILE, _PLACES = "scorecard.csv", "places"
_OWN = ("encounters", "labs", "pace", "safety", "tracks")
_FILES = Path(suites.__file__).parent
_GROUP = "f1tenth_judge.suites"


def suite(options) -> int:
    """Run the cases of a suite, and print how many were passed and which were the worst."""
    if options.name is None:
        for name, each in all_suites().items():
            print(f"{name:14}{each.text}")
        return PASSED
    if options.name not in all_suites():
        raise ScenarioError(f"no suite '{options.name}'; there are: {', '.join(all_suites())}")
    key = all_suites()[options.name].planner_key
    planners = [each.replace(PLANNER, key, 1) for each in planner_settings(options)]
    settings = [*options.set, *planners]
    check_many(options)
    folder = results_of(options) / "suite" / options.name
    with writing(folder):
        (folder / _PLACES).mkdir(parents=True, exist_ok=True)
    check_table_file(folder / _TABLE_FILE)
    sweep = _sweep(options, settings, folder)
    write = functools.partial(_write, options.name, sweep, folder)
    code = run_many(sweep, f"Suite {options.name}", folder, options, write)
    passed = all(result["passed"] for result in sweep.results.values())
    return code if passed or code else NOT_PASSED


def all_suites() -> Mapping[str, Suite]:
    """The suites of this package and of those that build on it, by name."""
    own = {name: importlib.import_module(f"{suites.__name__}.{name}").SUITE for name in _OWN}
    return dict(sorted({**own, **extensions(_GROUP)}.items()))


def _sweep(options, settings: list[str], folder: Path):
    from f1tenth_judge.batch.sweep import Case, Sweep

    chosen = all_suites()[options.name]
    if options.opponent:
        if chosen.scenario != "encounters":
            raise ScenarioError("--opponent is for the suite 'encounters'")
        settings.append(f"cars.robot2.driver={driver_text(planner_of(options.opponent, options))}")
    seeds = seed_settings(options)
    cases = chosen.cases(options.cases or chosen.chosen, folder / _PLACES)
    files = {name: f"{chosen.scenario.format(case=name)}.yaml" for name in cases}
    return Sweep(
        {
            ",".join([name, *seed]): Case(str(_FILES / files[name]), [*values, *map(parse_setting, seed)])
            for name, values in cases.items()
            for seed in seeds
        },
        folder,
        settings,
        options.bag,
        options.repeat,
    )


def _write(name: str, sweep, folder: Path) -> str:
    # Imported late: scipy takes longer than everything else that the command does.
    from f1tenth_judge.report.page import write_report
    from f1tenth_judge.results.intervals import Rate
    from f1tenth_judge.results.junit import junit_of_cases, write_junit
    from f1tenth_judge.suites.scorecard import scorecard, scorecard_page

    rows = [_row(job, row, sweep) for job, row in sweep.rows_of_jobs()]
    facts = {
        "suite": name,
        "planner": ", ".join(dict.fromkeys(row["planner"] for row in rows)),
        "passed": str(Rate(sum(row["passed"] for row in rows), len(rows))),
    }
    table, page = folder / _TABLE_FILE, folder / PAGE_FILE
    write_report(folder, folder / REPORT_FILE)
    with writing(folder), replacing(page) as temporary:
        beside = (REPORT_FILE, _TABLE_FILE, JUNIT_FILE)
        temporary.write_text(scorecard_page(f"Suite {name}", facts, rows, beside), encoding="utf-8")
        write_table(table, rows)
        write_junit(folder / JUNIT_FILE, junit_of_cases(f"suite_{name}", rows))
    for key, value in (*facts.items(), ("table", table), ("page", page)):
        print(f"{key + ':':19}{value}")
    print(scorecard(rows))
    return PAGE_FILE


def _row(job: Job, row: Mapping[str, Any], sweep) -> dict[str, Any]:
    result, reference = sweep.results[job], reference_of(sweep.plans[job])
    drivers = [planner_text(result, car) for car in result["cars"]]
    ratio = row["lap_time"] / reference.time if reference and row["lap_time"] else None
    return {"case": job.folder.name, "planner": drivers[0], **row, "of_reference": ratio}
