"""f1tenth league."""

import sys
from pathlib import Path

from f1tenth_judge.atomic import replacing
from f1tenth_judge.cli.exit_codes import exit_code
from f1tenth_judge.cli.options import expect_at_least, results_of
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.record.files import PAGE_FILE, REPORT_FILE
from f1tenth_judge.stop_request import StopRequest


def league(options) -> int:
    """Race planners at many places, and rank them; what has been raced is not raced again."""
    # Imported late, for the command that needs it.
    from f1tenth_judge.batch.sweep import Sweep
    from f1tenth_judge.league.league_file import read_league
    from f1tenth_judge.league.races import cases_of
    from f1tenth_judge.report.live.watching import watched_jobs

    expect_at_least(1, options.workers, "--jobs")
    wanted = read_league(options.file)
    folder = results_of(options) / "league" / options.file.stem
    cases, left_out = cases_of(wanted, options.file.resolve().parent, folder)
    if not cases:
        raise ScenarioError("\n".join(dict.fromkeys(left_out.values())))
    sweep = Sweep({each.name: case for each, case in cases.items()}, folder, options.set, options.bag)
    title = f"League {options.file.stem}"
    with StopRequest().listening() as stop, watched_jobs(sweep.jobs, title, folder, options.watch) as lead_to:
        sweep.run(stop, options.workers, options.scheduler)
        for problem in [] if stop.signal else sweep.problems:
            print(f"f1tenth: {problem}", file=sys.stderr)
        found = {job.name: result for job, result in sweep.results.items()}
        results = {each: found[each.name] for each in cases if each.name in found}
        if results:
            _write(options.file.stem, wanted, results, left_out, folder)
            lead_to(f"/{PAGE_FILE}")
    return exit_code(len(results) == len(cases), stop)


def _write(name: str, wanted, results, left_out, folder: Path) -> None:
    from f1tenth_judge.league.page import league_page
    from f1tenth_judge.league.standings import standings
    from f1tenth_judge.report.page import write_report

    ranking = standings(wanted, results)
    write_report(folder, folder / REPORT_FILE)
    file = folder / PAGE_FILE
    with writing(file), replacing(file) as temporary:
        temporary.write_text(
            league_page(f"League {name}", wanted, ranking, results, left_out), encoding="utf-8"
        )
    for rank, each in enumerate(ranking, 1):
        pace = "no lap" if each.pace is None else f"pace {each.pace:.3f}"
        print(f"{rank:3}  {each.name:24}{each.finished} of {each.raced} finished, {pace}, {each.won} won")
    print(f"{'page:':19}{file}")
