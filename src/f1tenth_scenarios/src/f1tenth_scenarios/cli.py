"""The command `scenario`: list, check, run, sweep, report, keys."""

import argparse
import dataclasses
import os
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Optional

from f1tenth_scenarios import places, versions
from f1tenth_scenarios.batch.jobs import Job, Outcome, run_jobs
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.launch.private_master import private_master
from f1tenth_scenarios.results.console import CountLine, ProgressLine, cost_of_all, summary
from f1tenth_scenarios.scenario.describe import describe_keys
from f1tenth_scenarios.scenario.plan import make_plan
from f1tenth_scenarios.scenario.scenario import Scenario, read_scenario
from f1tenth_scenarios.stop_request import StopRequest

# Exit codes.
PASSED, NOT_PASSED, BAD_INPUT = 0, 1, 2


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run the command; returns the exit code."""
    options = _parser().parse_args(arguments)
    try:
        return options.action(options)
    except ScenarioError as error:
        print(f"scenario: {error}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        return 128 + signal.SIGINT
    except BrokenPipeError:  # as in `scenario list | head -1`
        # What is left in the buffer would be the next broken pipe.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 128 + signal.SIGPIPE


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="scenario", description="Runs and judges scenarios of the F1/10 car."
    )
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    _add(commands, "list", _list, "print the scenarios and what each of them tests")
    _add(commands, "keys", _keys, "print all keys of a scenario file")
    check = _add(commands, "check", _check, "validate scenarios without running them")
    check.add_argument("names", nargs="*", metavar="NAME", help="scenario or file; default: all")
    run = _add(commands, "run", _run, "run scenarios; exit code 0 if each ended as expected")
    run.add_argument("names", nargs="*", metavar="NAME", help="scenario or file")
    run.add_argument("--all", action="store_true", help="run all scenarios of the package")
    run.add_argument("--jobs", type=int, default=1, metavar="N", help="run N at a time; default: 1")
    _add_results(run, "write to FOLDER/NAME")
    run.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help=_SET)
    run.add_argument(
        "--repeat", type=int, metavar="N", help="run N times and say how much the results differ"
    )
    run.add_argument("--bag", action="store_true", help="keep the bag, also of runs that pass")
    run.add_argument("--report", action="store_true", help="write the report afterwards")
    sweep = _add(commands, "sweep", _sweep, "run many variations of a scenario in parallel")
    sweep.add_argument("name", metavar="NAME", help="scenario or file")
    sweep.add_argument("--vary", action="append", required=True, metavar="KEY=VALUES", help=_VARY)
    sweep.add_argument("--workers", type=int, metavar="N", help="local processes; default: one a core")
    sweep.add_argument("--scheduler", metavar="URI", help="use this Dask cluster, as in tcp://host:8786")
    sweep.add_argument("--output", type=Path, metavar="FILE", help=_TABLE)
    _add_results(sweep, "write to FOLDER/sweep/NAME")
    report = _add(commands, "report", _report, "write one HTML file with all runs and their replays")
    _add_results(report, "read FOLDER/*")
    report.add_argument("--against", type=Path, metavar="FOLDER", help=_AGAINST)
    report.add_argument(
        "--output", type=Path, metavar="FILE", help=f"default: {_REPORT_FILE} in the results folder"
    )
    return parser


_REPORT_FILE = "report.html"
_SET = "replace a value of the file, as in mu=0.3 or limits.timeout=20"
_VARY = "FIRST:LAST (whole numbers), FIRST:LAST:COUNT or A,B,C; several keys: every combination"
_TABLE = "one more table of the runs: FILE.parquet keeps types, FILE.csv is text"
_AGAINST = "results to compare with; default: those of the commit before, which each run keeps"


def _add_results(command, text):
    default = "$F1TENTH_RESULTS or results of the workspace"
    command.add_argument("--results", type=Path, metavar="FOLDER", help=f"{text}; default: {default}")


def _add(commands, name, action, text):
    command = commands.add_parser(name, help=text, description=text)
    command.set_defaults(action=action)
    return command


def _list(_options) -> int:
    for name in places.scenario_names():
        scenario = read_scenario(places.scenario_file(name))
        print(f"{name:24}{scenario.expected.value:11}{scenario.description}")
    return PASSED


def _keys(_options) -> int:
    print(describe_keys(Scenario))
    return PASSED


def _check(options) -> int:
    failed = 0
    for name in options.names or places.scenario_names():
        try:
            print(f"{make_plan(name).name}: ok")
        except ScenarioError as error:
            failed += 1
            print(error, file=sys.stderr)
    return BAD_INPUT if failed else PASSED


def _report(options) -> int:
    # Here and below imported late: what takes long to import, for the command that needs it.
    from f1tenth_scenarios.report.page import write_report

    results = _results(options)
    output = (options.output or results / _REPORT_FILE).resolve()
    if options.against and not options.against.is_dir():
        raise ScenarioError(f"--against {options.against}: no such folder")
    problems = write_report(results, output, options.against.resolve() if options.against else None)
    for problem in problems:
        print(f"scenario: {problem}", file=sys.stderr)
    print(f"{'report:':19}{output}")
    return NOT_PASSED if problems else PASSED


def _sweep(options) -> int:
    from f1tenth_scenarios.batch.sweep import sweep

    if options.workers is not None and options.workers < 1:
        raise ScenarioError(f"--workers is {options.workers}, must be at least 1")
    output = options.output.resolve() if options.output else None
    with StopRequest().listening() as stop:
        complete = sweep(
            options.name,
            options.vary,
            _results(options),
            stop,
            options.workers,
            options.scheduler,
            output,
        )
    return _code(complete, stop)


def _results(options) -> Path:
    return (options.results or places.results_root()).resolve()


def _code(passed: bool, stop: StopRequest) -> int:
    if stop.signal:
        return 128 + stop.signal
    return PASSED if passed else NOT_PASSED


def _repeat(options) -> int:
    if options.repeat < 2 or len(options.names) != 1:
        raise ScenarioError("--repeat is for one scenario, and at least 2 times")
    from f1tenth_scenarios.batch.repeat import repeat

    with StopRequest().listening() as stop:
        steady = repeat(options.names[0], options.repeat, _results(options), options.set, stop, options.jobs)
    return _code(steady, stop)


def _run(options) -> int:
    _check_run(options)
    if options.repeat is not None:
        return _repeat(options)
    names = places.scenario_names() if options.all else options.names
    if len(names) == 1:
        code = _run_one(names[0], options)
    else:
        for name in names:
            make_plan(name, settings=options.set)
        code = _run_each(names, options)
    if options.report and code in (PASSED, NOT_PASSED):
        _report(_parser().parse_args(["report", *_results_option(options.results)]))
    return code


def _check_run(options) -> None:
    if options.jobs < 1:
        raise ScenarioError(f"--jobs is {options.jobs}, must be at least 1")
    if options.all == bool(options.names):
        raise ScenarioError("run needs either names of scenarios or --all")


def _results_option(results: Optional[Path]) -> list[str]:
    return ["--results", str(results)] if results else []


def _run_one(name: str, options) -> int:
    versions.ask_commit()
    folder = _results(options) / places.scenario_file(name).stem
    plan = dataclasses.replace(make_plan(name, folder, options.set), keep_bag=options.bag)
    from f1tenth_scenarios.run.ros_session import run_with_ros

    progress = ProgressLine(plan.name)
    with StopRequest().listening() as stop, private_master():
        result = run_with_ros(plan, stop, progress.update)
    progress.clear()
    print(summary(result, plan), flush=True)
    return _code(result.passed, stop)


def _run_each(names: Sequence[str], options) -> int:
    """A process for each, because a process can be a ROS node only once."""
    results = str(_results(options))
    extra = ("--bag",) if options.bag else ()
    jobs = [Job(str(places.scenario_file(name)), tuple(options.set), results, extra) for name in names]
    outcomes: list[Outcome] = []
    bar = CountLine("scenarios", len(jobs))

    def finished(outcome: Outcome) -> None:
        outcomes.append(outcome)
        bar.clear()
        print(outcome.output, end="", flush=True)
        if options.jobs > 1:
            bar.update(outcome.exit_code == PASSED)

    with StopRequest().listening() as stop:
        run_jobs(jobs, stop, finished, options.jobs, shown=options.jobs == 1)
    bar.clear()
    passed = sum(each.exit_code == PASSED for each in outcomes)
    if not stop.signal:
        if costs := {each.job.folder.name: each.result["times"]["cost"] for each in outcomes if each.result}:
            print(cost_of_all(costs))
        print(f"{passed} of {len(jobs)} scenarios passed")
    return _code(passed == len(jobs), stop)
