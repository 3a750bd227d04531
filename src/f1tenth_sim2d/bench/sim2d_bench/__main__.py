"""The command line: python3 -m sim2d_bench [KEY ...] [--output FILE]."""

import argparse
import sys
from pathlib import Path

from . import report
from .benchmark import Measured, NotAvailable, all_benchmarks
from .places import REPOSITORY


def parse_arguments(benchmarks):
    """Return the keys to measure and where to write them."""
    parser = argparse.ArgumentParser(prog="sim2d_bench", description="Measure the simulator.")
    parser.add_argument("keys", nargs="*", metavar="KEY", help=f"of {', '.join(benchmarks)}; default: all")
    parser.add_argument("--output", type=Path, default=REPOSITORY / "results" / "bench.json", metavar="FILE")
    parser.add_argument("--check", action="store_true", help="exit with 1 if a floor is not kept")
    arguments = parser.parse_args()
    for key in arguments.keys:
        if key not in benchmarks:
            parser.error(f"no key {key}; allowed are {', '.join(benchmarks)}")
    return arguments


def result_of(benchmark):
    """Measure it, if this machine can."""
    try:
        measured = benchmark.measure()
    except NotAvailable as missing:
        return report.Result(benchmark, None, str(missing))
    if not isinstance(measured, Measured):
        raise TypeError(f"{benchmark.key}: its function returned {measured!r}, not a Measured")
    return report.Result(benchmark, measured)


def main():
    """Measure, print, write; return the exit code."""
    benchmarks = all_benchmarks()
    arguments = parse_arguments(benchmarks)
    results = []
    print(report.header())
    for key in arguments.keys or benchmarks:
        results.append(result_of(benchmarks[key]))
        print(report.row(results[-1]), flush=True)
        report.write_json(results, arguments.output)
    print(f"written: {arguments.output}")
    return int(arguments.check and not all(result.ok for result in results))


if __name__ == "__main__":
    sys.exit(main())
