"""What a benchmark is, and the list of all."""

import importlib
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Optional


class NotAvailable(Exception):  # noqa: N818  it is no error
    """Something that a measurement needs is not on this machine; the message says what."""


@dataclass(frozen=True)
class Measured:
    """What a measurement found."""

    value: float
    """In the unit of the benchmark."""
    details: dict = field(default_factory=dict)
    """What else is worth keeping, for bench.json."""
    problem: str = ""
    """Why the figure does not count though it may be within its bound, for example lost messages."""


@dataclass(frozen=True)
class Benchmark:
    """A key of bench.json, with the bound that its figure has to keep."""

    key: str
    unit: str
    measure: Callable[[], Measured]
    at_least: Optional[float] = None
    at_most: Optional[float] = None

    @property
    def bound(self):
        """The floor, as a person reads it."""
        return f">= {self.at_least:g}" if self.at_most is None else f"<= {self.at_most:g}"

    def keeps_bound(self, value):
        """Whether a value is good enough."""
        return value >= self.at_least if self.at_most is None else value <= self.at_most


_benchmarks = {}


def benchmark(key, unit, at_least=None, at_most=None):
    """Make a benchmark of the function below: one that takes nothing and returns a Measured.

    Args:
        key: its name in bench.json.
        unit: of the value.
        at_least, at_most: its bound; one of the two.
    """
    if (at_least is None) == (at_most is None):
        raise ValueError(f"{key}: a benchmark has either at_least or at_most")

    def add(measure):
        if key in _benchmarks:
            raise ValueError(f"{key}: there are two benchmarks of this name")
        _benchmarks[key] = Benchmark(key, unit, measure, at_least, at_most)
        return measure

    return add


def all_benchmarks():
    """Every Benchmark of the modules under keys/, by key, in the order of modules and keys."""
    keys = importlib.import_module(f"{__package__}.keys")
    for module in sorted(info.name for info in pkgutil.iter_modules(keys.__path__)):
        importlib.import_module(f"{keys.__name__}.{module}")
    return dict(_benchmarks)
