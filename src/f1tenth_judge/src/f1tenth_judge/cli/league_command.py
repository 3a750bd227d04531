"""f1tenth league."""

import dataclasses
import functools
import re
from pathlib import Path

from f1tenth_judge.atomic import replacing
from f1tenth_judge.cli.many import check_many, run_many
from f1tenth_judge.cli.options import planners_named, results_of
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.record.files import PAGE_FILE, REPORT_FILE
from f1tenth_judge.suites.suite import seeds


def league(options) -> int:
    """Race planners at many places, and rank them; what has been raced is not raced again."""
    # Imported late, for the command that needs it.
    from f1tenth_judge.batch.sweep import Sweep
    from f1tenth_judge.league.races import cases_of

    check_many(options)
    wanted = _wanted(options)
    name = options.file.stem
    folder = results_of(options) / "league" / name
    cases, left_out = cases_of(wanted, options.file.resolve().parent, folder)
    if not cases:
        raise ScenarioError("\n".join(dict.fromkeys(left_out.values())))
    by_name = {each.name: case for each, case in cases.items()}
    sweep = Sweep(by_name, folder, options.set, options.bag, options.repeat)
    write = functools.partial(_write, name, wanted, cases, sweep, left_out, folder)
    return run_many(sweep, f"League {name}", folder, options, write)


def _wanted(options):
    """What the file and the options say."""
    from f1tenth_judge.league.league_file import Entry, read_league

    wanted = read_league(options.file)
    more = [Entry(_name(each.name), given=each) for each in planners_named(options)]
    wanted = dataclasses.replace(
        wanted,
        planners=(*wanted.planners, *more),
        seeds=tuple(seeds(options.seeds, "--seeds")) if options.seeds else wanted.seeds,
    )
    if problem := wanted.problem():
        raise ScenarioError(f"{options.file}: with the options: {' '.join(problem)}")
    return wanted


def _name(driver: str) -> str:
    """Of a planner that has none: of its class or file."""
    return re.sub(r"\W", "_", re.split("[:/]", driver.removesuffix(".launch"))[-1])


def _write(name: str, wanted, cases, sweep, left_out, folder: Path) -> str:
    from f1tenth_judge.league.page import league_page
    from f1tenth_judge.league.standings import standings
    from f1tenth_judge.report.page import write_report

    found = {job.name: result for job, result in sweep.results.items()}
    results = {each: found[each.name] for each in cases if each.name in found}
    ranking = standings(wanted, results)
    write_report(folder, folder / REPORT_FILE)
    file = folder / PAGE_FILE
    with writing(file), replacing(file) as temporary:
        temporary.write_text(
            league_page(f"League {name}", wanted, ranking, results, left_out), encoding="utf-8"
        )
    for rank, each in enumerate(ranking, 1):
        pace = "no lap" if each.pace is None else f"pace {each.pace:.3f}"
        won = f", {each.won} won" if wanted.pairs else ""
        print(f"{rank:3}  {each.name:24}{each.finished} of {each.raced} finished, {pace}{won}")
    print(f"{'page:':19}{file}")
    return PAGE_FILE
