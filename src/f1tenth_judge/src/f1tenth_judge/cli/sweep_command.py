"""f1tenth sweep."""

import sys

from f1tenth_judge.batch.table_file import check_table_file, write_table
from f1tenth_judge.cli.exit_codes import exit_code
from f1tenth_judge.cli.options import expect_at_least, results_of
from f1tenth_judge.errors import writing
from f1tenth_judge.places import lookup
from f1tenth_judge.stop_request import StopRequest

_TABLE_FILE, _PICTURE_FILE = "sweep.csv", "sweep.png"


def sweep(options) -> int:
    """Run many variations of a scenario; write a table and a picture, and print where they are."""
    from f1tenth_judge.batch.sweep import Case, Sweep, combinations

    expect_at_least(1, options.workers, "--jobs")
    output = options.output.resolve() if options.output else None
    with StopRequest().listening() as stop:
        if output:
            check_table_file(output)
        folder = results_of(options) / "sweep" / lookup.scenario_file(options.name).stem
        varied = combinations(options.vary)
        swept = Sweep({name: Case(options.name, values) for name, values in varied.items()}, folder)
        with writing(folder):
            folder.mkdir(parents=True, exist_ok=True)
        check_table_file(folder / _TABLE_FILE)
        swept.run(stop, options.workers, options.scheduler)
        # Runs that were told to stop have no result, and nothing is wrong with that.
        for problem in [] if stop.signal else swept.problems:
            print(f"f1tenth: {problem}", file=sys.stderr)
        if swept.results:
            _write(swept, folder, output)
    return exit_code(len(swept.results) == len(swept.jobs), stop)


def _write(swept, folder, output):
    # Imported late: matplotlib takes longer than everything else that the command does.
    from f1tenth_judge.batch.sweep_picture import write_picture

    rows = list(swept.rows())
    tables = [folder / _TABLE_FILE, *([output] if output else [])]
    for table in tables:
        with writing(table):
            write_table(table, rows)
    picture = folder / _PICTURE_FILE
    with writing(picture):
        write_picture(picture, folder.name, rows, swept.keys)
    facts = [
        ("scenario", folder.name),
        ("passed", f"{sum(row['passed'] for row in rows)} of {len(rows)}"),
        ("reused", f"{len(swept.reused)} of {len(rows)}, of the same inputs"),
        *(("table", table) for table in tables),
        ("picture", picture),
    ]
    for key, value in facts:
        print(f"{key + ':':19}{value}")
