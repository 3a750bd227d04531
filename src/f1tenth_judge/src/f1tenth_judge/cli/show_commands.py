"""f1tenth list, keys, check, report."""

import sys

from f1tenth_judge.cli.exit_codes import BAD_INPUT, NOT_PASSED, PASSED
from f1tenth_judge.cli.options import results_of
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.plan.source import read_scenario
from f1tenth_judge.record.files import REPORT_FILE
from f1tenth_judge.scenario.describe import describe_keys
from f1tenth_judge.scenario.scenario import Scenario


def show_list(_options) -> int:
    """Print the scenarios and what each of them tests."""
    for name in lookup.scenario_names():
        scenario = read_scenario(lookup.scenario_file(name))
        print(f"{name:24}{scenario.expected.value:11}{scenario.description}")
    return PASSED


def show_keys(_options) -> int:
    """Print all keys of a scenario file."""
    print(describe_keys(Scenario))
    return PASSED


def check(options) -> int:
    """Validate scenarios without running them."""
    failed = 0
    for name in options.names or lookup.scenario_names():
        try:
            print(f"{make_plan(name).name}: ok")
        except ScenarioError as error:
            failed += 1
            print(error, file=sys.stderr)
    return BAD_INPUT if failed else PASSED


def report(options) -> int:
    """Write one HTML file with all runs."""
    # Imported late: what takes long to import, for the command that needs it.
    from f1tenth_judge.report.page import write_report

    results = results_of(options)
    output = (getattr(options, "output", None) or results / REPORT_FILE).resolve()
    against = getattr(options, "against", None)
    if against and not against.is_dir():
        raise ScenarioError(f"--against {against}: no such folder")
    problems = write_report(results, output, against.resolve() if against else None)
    for problem in problems:
        print(f"f1tenth: {problem}", file=sys.stderr)
    print(f"{'report:':19}{output}")
    return NOT_PASSED if problems else PASSED


def export(options) -> int:
    """Draw a run into a file."""
    from f1tenth_judge.report.export import export as draw

    run = options.run if options.run.is_dir() else results_of(options) / options.run
    draw(run, options.output)
    print(f"{'export:':19}{options.output.resolve()}")
    return PASSED
