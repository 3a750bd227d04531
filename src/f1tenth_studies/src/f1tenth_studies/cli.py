"""The commands `study` and `race_reference`."""

import argparse
import importlib
import pkgutil
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Callable, Optional

from f1tenth_judge.atomic import replacing
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.places import lookup
from f1tenth_judge.results.reference_laps import reference_laps_text
from f1tenth_judge.stop_request import StopRequest
from f1tenth_scenarios.batch.sweep import Sweep
from f1tenth_scenarios.cli.exit_codes import BAD_INPUT, NOT_PASSED, PASSED
from f1tenth_scenarios.cli.options import expect_at_least

from f1tenth_studies import studies
from f1tenth_studies.optimum.car_limits import CLEARANCE, read_limits
from f1tenth_studies.optimum.fastest_lap import FastestLap, compute_fastest_lap, write_raceline
from f1tenth_studies.optimum.track import load_track
from f1tenth_studies.study import Run, Study, place_of
from f1tenth_studies.table import document

PACKAGE = "f1tenth_studies"
STUDIES = sorted(each.name for each in pkgutil.iter_modules(studies.__path__))


def study_main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run `study`; returns the exit code: 1 when a run was not good enough."""
    parser = argparse.ArgumentParser(prog="study", description="Sweeps a scenario and makes a table of it.")
    parser.add_argument("name", choices=STUDIES)
    parser.add_argument(
        "--vary", action="append", default=[], metavar="KEY=VALUES", help="in the place of the study's own"
    )
    parser.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="the same in all runs"
    )
    parser.add_argument("--table", type=Path, metavar="FILE", help="write the table there, too")
    parser.add_argument("--results", type=Path, metavar="FOLDER", help="default: results of the workspace")
    parser.add_argument("--jobs", type=int, metavar="N", help="runs at a time; default: one per core")
    return _guarded(parser.prog, _study, parser.parse_args(arguments))


def reference_main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run `race_reference`; returns the exit code."""
    parser = argparse.ArgumentParser(
        prog="race_reference", description="Computes the fastest lap of circuits for the simulator's car."
    )
    parser.add_argument(
        "names", nargs="*", default=lookup.circuits(), metavar="NAME", help="circuit, or X_centerline.csv"
    )
    parser.add_argument(
        "--clearance", type=float, default=CLEARANCE, metavar="M", help="beside the car (%(default)s)"
    )
    parser.add_argument("-o", "--output", type=Path, metavar="FOLDER", help="write NAME_raceline.csv there")
    parser.add_argument("--laps", type=Path, metavar="FILE", help="write the lap times there, as YAML")
    return _guarded(parser.prog, _references, parser.parse_args(arguments))


def _guarded(program: str, action: Callable, options) -> int:
    """Run an action; report a user's mistake in one line. Returns the exit code."""
    try:
        return action(options)
    except ScenarioError as error:
        print(f"{program}: {error}", file=sys.stderr)
        return BAD_INPUT


def _study(options) -> int:
    _expect_folder_of("--table", options.table)
    expect_at_least(1, options.jobs, "--jobs")
    study = importlib.import_module(f"{PACKAGE}.studies.{options.name}").STUDY
    study.expect_others(options.set)
    scenario = lookup.package_path(PACKAGE) / "scenarios" / f"{study.scenario}.yaml"
    results = (options.results or lookup.results_root()).resolve()
    vary = study.make(study.varied(options.vary), results / "places" / options.name)
    variations = [f"{key}={values}" for key, values in vary.items()]
    sweep = Sweep(str(scenario), variations, results, options.set)
    with StopRequest().listening() as stop:
        sweep.run(stop, options.jobs)
    if stop.signal:
        return 128 + stop.signal
    runs = _runs(sweep, study)
    whole = [run for run in runs if not run.broke_down]
    if whole:
        _publish(document(study, whole, _command(options)), options.table)
    return _say(options.name, study, runs, sweep)


def _runs(sweep: Sweep, study: Study) -> list[Run]:
    found = []
    for job in sweep.jobs:
        if job in sweep.results:
            values = dict(each.split("=", 1) for each in job.settings)
            found.append(Run(study.about(values), sweep.results[job], job.folder))
    return found


def _publish(text: str, path: Optional[Path]) -> None:
    print(text)
    if path:
        _write(path, text)


def _write(path: Path, text: str) -> None:
    with writing(path), replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


def _expect_folder_of(option: str, path: Optional[Path]) -> None:
    """Refuse a file in a folder that is not there before the work, not after it."""
    if path and not path.resolve().parent.is_dir():
        raise ScenarioError(f"{option} {path}: there is no such folder")


def _say(name: str, study: Study, runs: Sequence[Run], sweep: Sweep) -> int:
    bad = [f"{_name(run, sweep.keys)}: {problem}" for run in runs if (problem := study.problem(run))]
    for text in [*sweep.problems, *bad]:
        print(f"study {name}: {text}", file=sys.stderr)
    return NOT_PASSED if bad or sweep.problems else PASSED


def _name(run: Run, keys: Sequence[str]) -> str:
    return ", ".join(place_of(run.values) if key == "world" else run.values[key] for key in keys)


def _command(options) -> str:
    parts = [f"rosrun {PACKAGE} study {options.name}"]
    parts += [f"--vary {each}" for each in options.vary] + [f"--set {each}" for each in options.set]
    return " ".join([*parts, *([f"--table {options.table}"] if options.table else [])])


def _references(options) -> int:
    _expect_folder_of("--laps", options.laps)
    _expect_folder_of("-o", options.output and options.output / "*")
    limits = read_limits(options.clearance)
    laps = {}
    for name in options.names:
        lap = compute_fastest_lap(load_track(name), limits)
        laps[name] = lap.lap_time
        print(_describe(name, lap), flush=True)
        if options.output:
            stem = Path(name).stem.removesuffix("_centerline")
            write_raceline(options.output / f"{stem}_raceline.csv", lap, limits)
    if options.laps:
        _write(options.laps, reference_laps_text(laps))
    return PASSED


def _describe(name: str, lap: FastestLap) -> str:
    low, high = lap.speed.min(), lap.speed.max()
    return f"{name}: {lap.lap_time:.3f} s, {lap.s[-1]:.1f} m, {low:.1f} to {high:.1f} m/s"
