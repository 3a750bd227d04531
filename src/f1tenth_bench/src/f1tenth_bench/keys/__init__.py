"""The benchmarks: every function of a module here that is marked as one."""

import importlib
import pkgutil

from f1tenth_bench.benchmark import registered


def all_benchmarks():
    """Every Benchmark by key, in the order of modules and keys."""
    for module in sorted(info.name for info in pkgutil.iter_modules(__path__)):
        importlib.import_module(f"{__name__}.{module}")
    return dict(registered)
