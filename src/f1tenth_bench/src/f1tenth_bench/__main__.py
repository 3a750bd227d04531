"""The command line: python3 -m f1tenth_bench [KEY ...] [--output FILE]."""

import argparse
import sys
from pathlib import Path

from f1tenth_judge.errors import ScenarioError

from f1tenth_bench import report
from f1tenth_bench.benchmark import Measured, NotAvailable
from f1tenth_bench.calibration import calibrate
from f1tenth_bench.keys import all_benchmarks


def parse_arguments(benchmarks):
    """Return the keys to measure and where to write them."""
    parser = argparse.ArgumentParser(
        prog="f1tenth_bench", description="Measure simulator, planner and scenarios."
    )
    parser.add_argument("keys", nargs="*", metavar="KEY", help=f"of {', '.join(benchmarks)}; default: all")
    parser.add_argument("--output", type=Path, default=Path("results/bench.json"), metavar="FILE")
    parser.add_argument("--check", action="store_true", help="exit with 1 if a limit is not kept")
    arguments = parser.parse_args()
    for key in arguments.keys:
        if key not in benchmarks:
            parser.error(f"no key {key}; allowed are {', '.join(benchmarks)}")
    return arguments


def result_of(benchmark, before):
    """Measure it, if this machine can; return (Result, Calibration just after), given that just before."""
    try:
        measured = benchmark.measure()
    except (NotAvailable, ScenarioError) as missing:
        return report.Result(benchmark, None, reason=str(missing)), before
    if not isinstance(measured, Measured):
        raise TypeError(f"{benchmark.key}: its function returned {measured!r}, not a Measured")
    after = calibrate()
    return report.Result(benchmark, measured, before.at_best(after).slowness(benchmark.of_messages)), after


def main():
    """Measure, print, write; return the exit code."""
    benchmarks = all_benchmarks()
    arguments = parse_arguments(benchmarks)
    results = []
    try:
        calibration = calibrate()
    except NotAvailable as missing:
        sys.exit(f"bench: {missing}")
    print(report.header())
    for key in arguments.keys or benchmarks:
        result, calibration = result_of(benchmarks[key], calibration)
        results.append(result)
        print(report.row(result), flush=True)
        report.write_json(results, arguments.output)
    print(f"written: {arguments.output}")
    return int(arguments.check and not all(result.ok for result in results))


if __name__ == "__main__":
    sys.exit(main())
