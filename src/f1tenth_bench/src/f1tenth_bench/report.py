"""Results as bench.json and as a table."""

import json
from dataclasses import dataclass
from typing import Optional

from f1tenth_judge.atomic import replacing

from f1tenth_bench.benchmark import Benchmark, Measured

COLUMNS = "{:<22} {:>12} {:<10} {:>10} {:>12}  {}"


@dataclass(frozen=True)
class Result:
    """A benchmark and what came of it."""

    benchmark: Benchmark
    measured: Optional[Measured]
    """None if it could not be measured."""
    slowness: float = 1.0
    """Of the machine around this measurement; see Calibration."""
    reason: str = ""
    """Why it could not be measured."""

    @property
    def ok(self):
        """Whether the limit is kept and nothing speaks against it; None if it was not measured."""
        if self.measured is None:
            return None
        return not self.measured.problem and self.benchmark.keeps_limit(self.measured.value, self.slowness)

    @property
    def verdict(self):
        """The last column of the table."""
        if self.measured is None:
            return f"not measured: {self.reason}"
        if self.measured.problem:
            return f"NO: {self.measured.problem}"
        return "yes" if self.ok else "NO"

    def as_dict(self):
        """The entry of bench.json."""
        return {
            "measured": self.measured.value if self.measured else None,
            "unit": self.benchmark.unit,
            "limit": self.benchmark.limit(self.slowness),
            "bound": "at least" if self.benchmark.at_most is None else "at most",
            "reference_limit": self.benchmark.reference_limit,
            "slowness": self.slowness,
            "ok": self.ok,
            "remark": self.measured.problem if self.measured else self.reason,
            "details": self.measured.details if self.measured else {},
        }


def header():
    """The first line of the table."""
    return COLUMNS.format("key", "measured", "unit", "limit", "of reference", "ok")


def row(result):
    """The line of a result."""
    benchmark = result.benchmark
    sign = ">=" if benchmark.at_most is None else "<="
    return COLUMNS.format(
        benchmark.key,
        f"{result.measured.value:.4g}" if result.measured else "-",
        benchmark.unit,
        f"{sign} {benchmark.limit(result.slowness):.4g}",
        f"{sign} {benchmark.reference_limit:g}",
        result.verdict,
    )


def write_json(results, path):
    """Write bench.json: a key of its own for each result. Keys of an older file that were not measured stay.

    Raises:
        OSError: the file cannot be written.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    entries = json.loads(path.read_text()) if path.exists() else {}
    entries.update({result.benchmark.key: result.as_dict() for result in results})
    with replacing(path) as temporary:
        temporary.write_text(json.dumps(entries, indent=2) + "\n")
