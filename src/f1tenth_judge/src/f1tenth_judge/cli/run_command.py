"""f1tenth run."""

import dataclasses
import urllib.parse
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable

from f1tenth_judge.batch.jobs import Job, Outcome, run_jobs
from f1tenth_judge.cli.exit_codes import NOT_PASSED, PASSED, exit_code
from f1tenth_judge.cli.options import check_name, expect_at_least, planner_settings, results_of, seed_settings
from f1tenth_judge.cli.show_commands import report
from f1tenth_judge.errors import NotApplicableError, ScenarioError, writing
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.record.files import REPORT_FILE
from f1tenth_judge.results.console import CountLine, ProgressLine, cost_of_all, summary
from f1tenth_judge.results.result import Result
from f1tenth_judge.run.memory import require_memory
from f1tenth_judge.run.ros import require_runner, ros_runner
from f1tenth_judge.stop_request import StopRequest

if TYPE_CHECKING:
    from f1tenth_judge.run.loop import Progress

_REPEAT = "--repeat is for one scenario, and at least 2 times"


def run(options) -> int:
    """Run scenarios."""
    _check(options)
    settings = [*options.set, *planner_settings(options)]
    if options.reference_limits:
        settings.append("criteria.of_reference=[]")
    if options.repeat is not None:
        if len(options.names) != 1:
            raise ScenarioError(_REPEAT)
        check_repeat(options)
        return run_repeatedly(options.names[0], options, settings)
    names = lookup.scenario_names() if options.all else options.names
    if len(names) == 1 and not options.seeds:
        name = options.name or lookup.scenario_file(names[0]).stem
        plan = make_plan(names[0], results_of(options) / name, settings)
        return run_with_report(dataclasses.replace(plan, name=name, keep_bag=options.bag), options)
    return run_each(names, settings, options)


def run_plan(plan: Plan) -> int:
    """Run one scenario and print the outcome; returns the exit code.

    Raises:
        ScenarioError: it cannot be run here.
    """
    require_memory()
    require_runner(plan)
    progress = ProgressLine(plan.name)
    with StopRequest().listening() as stop:
        run = ros_runner() if plan.needs_ros else None
        result = (run or _run_without_ros)(plan, stop, progress.update)
    progress.clear()
    print(summary(result, plan), flush=True)
    return exit_code(result.passed, stop)


def _run_without_ros(plan: Plan, stop: StopRequest, progress: "Progress") -> Result:
    from f1tenth_judge.drivers.starting import start_drivers
    from f1tenth_judge.run.execute import execute

    return execute(plan, start_drivers, stop, progress)


def run_with_report(plan: Plan, options) -> int:
    """Run one scenario, shown in browsers and in the report if that is wanted; returns the exit code."""
    if not options.watch:
        return with_report(run_plan(plan), options)
    from f1tenth_judge.report.live.task import task_of

    return watched_with_report([task_of(plan)], plan.name, options, lambda: run_plan(plan))


def watched_with_report(
    tasks: Sequence[Mapping[str, Any]], title: str, options, act: Callable[[], int]
) -> int:
    """Run what is watched, and send the watchers to the report of it; returns the exit code."""
    from f1tenth_judge.report.live.watching import watched

    options.report = True
    with watched(tasks, title, results_of(options)) as lead_to:
        code = with_report(act(), options)
        if code in (PASSED, NOT_PASSED):
            only = f"#{urllib.parse.quote(title, safe='')}" if len(tasks) == 1 else ""
            lead_to(f"/{REPORT_FILE}{only}")
    return code


def with_report(code: int, options) -> int:
    """Write the report afterwards if that is wanted; returns the exit code."""
    if options.report and code in (PASSED, NOT_PASSED):
        report(options)
    return code


def run_repeatedly(name: str, options, settings: Sequence[str]) -> int:
    """Run one scenario, which has been checked, --repeat times, and print how much the results differ.

    Returns:
        The exit code.
    """
    from f1tenth_judge.batch.repeat import repeat

    with StopRequest().listening() as stop:
        results, at_once = results_of(options), options.workers or 1
        steady = repeat(name, options.repeat, results, settings, stop, at_once, options.bag)
    return exit_code(steady, stop)


def check_repeat(options) -> None:
    """Refuse a --repeat of too few times, or with options that would change nothing.

    Raises:
        ScenarioError: the option that is wrong.
    """
    if options.repeat < 2:
        raise ScenarioError(_REPEAT)
    for option in ("report", "attach", "save", "seeds", "watch"):
        if getattr(options, option, None):
            raise ScenarioError(f"--{option} is not for --repeat")


def _check(options) -> None:
    expect_at_least(1, options.workers, "--jobs")
    check_name(options.name)
    if options.name and (len(options.names) != 1 or options.repeat is not None or options.seeds):
        raise ScenarioError("--name is for one run of one scenario")
    if options.all == bool(options.names):
        raise ScenarioError("run needs either names of scenarios or --all")


def run_each(names: Sequence[str], settings: Sequence[str], options) -> int:
    """Run scenarios, with each of the seeds, a process for each run; returns the exit code.

    Raises:
        ScenarioError: bad input, or results would be written to one folder.
    """
    _check_folders(names, results_of(options))
    left_out = _not_applicable(names, settings)
    files = [lookup.scenario_file(name) for name in names if name not in left_out]
    extra = ("--bag",) if options.bag else ()
    jobs = [
        Job(
            str(file),
            (*settings, *seed),
            str(results_of(options)),
            extra,
            name=",".join([file.stem, *seed]) if seed else "",
        )
        for file in files
        for seed in seed_settings(options)
    ]
    if not options.watch:
        return with_report(_run_jobs(jobs, left_out, options), options)
    from f1tenth_judge.report.live.watching import task_of_job

    tasks, title = [task_of_job(job) for job in jobs], f"{len(jobs)} scenarios"
    return watched_with_report(tasks, title, options, lambda: _run_jobs(jobs, left_out, options))


def _run_jobs(jobs: Sequence[Job], left_out: dict[str, str], options) -> int:
    outcomes: list[Outcome] = []
    what = "runs" if options.seeds else "scenarios"
    bar = CountLine(what, len(jobs), each_is_told=True)
    with StopRequest().listening() as stop:
        for outcome in run_jobs(jobs, stop, options.workers or 1):
            outcomes.append(outcome)
            bar.clear()
            print(f"{len(outcomes):4} of {len(jobs)}  {_line(outcome)}", flush=True)
            bar.update(outcome.exit_code == PASSED)
    bar.clear()
    failed = [each for each in outcomes if each.exit_code != PASSED]
    _sum_up(outcomes, failed, left_out, len(jobs), what)
    return exit_code(len(outcomes) == len(jobs) and not failed, stop)


def _line(outcome: Outcome) -> str:
    head = f"{outcome.job.folder.name:32}{'passed' if outcome.exit_code == PASSED else 'FAILED':8}"
    if not (result := outcome.result):
        return f"{head}no result"
    figures = ((result["times"]["lap_time"], "s"), (result["minimum_clearance"], "m"))
    texts = ("" if value is None else f"{value:.3f} {unit}" for value, unit in figures)
    return f"{head}{result['verdict']:13}{next(texts):>10}{next(texts):>10}".rstrip()


def _check_folders(names: Sequence[str], results: Path) -> None:
    """Refuse scenarios that would overwrite each other's results, and a folder that cannot be made."""
    known: dict[Path, str] = {}
    for name in names:
        folder = results / lookup.scenario_file(name).stem
        if folder in known:
            raise ScenarioError(f"'{known[folder]}' and '{name}' would both be written to {folder}")
        known[folder] = name
    with writing(results):
        results.mkdir(parents=True, exist_ok=True)


def _not_applicable(names: Sequence[str], settings: Sequence[str]) -> dict[str, str]:
    """The scenarios that say nothing about the planner, and why; all others are checked here as well."""
    found = {}
    for name in names:
        try:
            require_runner(make_plan(name, settings=settings))
        except NotApplicableError as reason:
            found[name] = str(reason)
    if len(found) == len(names):
        raise ScenarioError("\n".join(found.values()))
    return found


def _sum_up(
    outcomes: Sequence[Outcome],
    failed: Sequence[Outcome],
    left_out: dict[str, str],
    count: int,
    what: str,
) -> None:
    """Those of the outcomes that failed in detail, and how many passed."""
    for each in failed:
        print(f"\n{each.output}", end="")
    if failed:
        print()
    for name, reason in left_out.items():
        print(f"{Path(name).stem:24}not applicable: {reason}")
    if costs := {each.job.folder.name: each.result["times"]["cost"] for each in outcomes if each.result}:
        print(cost_of_all(costs))
    others = f", {len(left_out)} not applicable" if left_out else ""
    others += f", {count - len(outcomes)} not run" if len(outcomes) < count else ""
    print(f"{len(outcomes) - len(failed)} of {count} {what} passed{others}")
