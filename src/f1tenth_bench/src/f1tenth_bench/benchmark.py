"""What a benchmark is."""

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
    """Why the figure does not count though it may be within its limit, for example lost messages."""


@dataclass(frozen=True)
class Benchmark:
    """A key of bench.json, with the limit that its figure has to keep."""

    key: str
    unit: str
    measure: Callable[[], Measured]
    at_least: Optional[float] = None
    at_most: Optional[float] = None
    is_ratio: bool = False
    """Of two things measured on the same machine, whose speed then does not count."""
    of_messages: bool = False
    """Most of what it measures is the kernel's work for messages between processes."""

    @property
    def reference_limit(self):
        """What the reference machine must reach, or keep."""
        return self.at_least if self.at_most is None else self.at_most

    def limit(self, slowness):
        """What this machine must reach, or keep, if it takes `slowness` times the reference's time."""
        if self.is_ratio:
            return self.reference_limit
        return self.at_least / slowness if self.at_most is None else self.at_most * slowness

    def keeps_limit(self, value, slowness):
        """Whether a value is good enough on such a machine."""
        limit = self.limit(slowness)
        return value >= limit if self.at_most is None else value <= limit


registered = {}
"""By key, every Benchmark of the modules imported so far; `keys.all_benchmarks` imports them all."""


def benchmark(key, unit, at_least=None, at_most=None, is_ratio=False, of_messages=False):
    """Make a benchmark of the function below: one that takes nothing and returns a Measured.

    Args:
        key: its name in bench.json.
        unit: of the value.
        at_least, at_most: its limit on the reference machine (calibration.py); one of the two.
        is_ratio: of two measurements of the same machine, whose speed does not count.
        of_messages: it stands and falls with messages between processes (Calibration.slowness).
    """
    if (at_least is None) == (at_most is None):
        raise ValueError(f"{key}: a benchmark has either at_least or at_most")

    def add(measure):
        if key in registered:
            raise ValueError(f"{key}: there are two benchmarks of this name")
        registered[key] = Benchmark(key, unit, measure, at_least, at_most, is_ratio, of_messages)
        return measure

    return add
