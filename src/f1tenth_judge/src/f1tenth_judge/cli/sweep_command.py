"""f1tenth sweep."""

from f1tenth_judge.batch.table_file import check_table_file, write_table
from f1tenth_judge.cli.many import check_many, run_many
from f1tenth_judge.cli.options import planner_settings, results_of
from f1tenth_judge.errors import writing
from f1tenth_judge.places import lookup
from f1tenth_judge.record.files import REPORT_FILE
from f1tenth_judge.suites.suite import seeds

_TABLE_FILE, _PICTURE_FILE = "sweep.csv", "sweep.png"


def sweep(options) -> int:
    """Run many variations of a scenario; write a table and a picture, and print where they are."""
    from f1tenth_judge.batch.sweep import Case, Sweep, combinations

    check_many(options)
    output = options.output.resolve() if options.output else None
    if output:
        check_table_file(output)
    name = lookup.scenario_file(options.name).stem
    folder = results_of(options) / "sweep" / name
    if options.seeds:
        seeds(options.seeds, "--seeds")
        options.vary.append(f"seed={options.seeds}")
    varied = combinations(options.vary)
    cases = {each: Case(options.name, values) for each, values in varied.items()}
    settings = [*options.set, *planner_settings(options)]
    swept = Sweep(cases, folder, settings, options.bag, options.repeat)
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
    check_table_file(folder / _TABLE_FILE)
    return run_many(swept, f"Sweep {name}", folder, options, lambda: _write(swept, folder, output, options))


def _write(swept, folder, output, options) -> str:
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
        *(("table", table) for table in tables),
        ("picture", picture),
    ]
    for key, value in facts:
        print(f"{key + ':':19}{value}")
    if options.watch:
        from f1tenth_judge.report.page import write_report

        write_report(folder, folder / REPORT_FILE)
    return REPORT_FILE
