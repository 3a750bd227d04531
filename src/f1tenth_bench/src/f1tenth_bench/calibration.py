"""How fast this machine is, seen from what a fixed piece of work takes here and on the reference machine.

Limits are relative to it: a slower machine, or a busy one, is no failure; a slower program is.
"""

import json
import math
import subprocess
from dataclasses import astuple, dataclass

from f1tenth_bench.places import executable


@dataclass(frozen=True)
class Calibration:
    """Processor time of the fixed work of calibration.cpp, s."""

    arithmetic_s: float
    memory_s: float
    messages_s: float

    def slowness(self, of_messages=False):
        """How many times the reference's time this machine takes.

        Args:
            of_messages: to pass messages between processes; otherwise to calculate, which is the geometric
                mean of arithmetic and memory work.
        """
        if of_messages:
            return self.messages_s / REFERENCE.messages_s
        return math.sqrt(self.arithmetic_s / REFERENCE.arithmetic_s * self.memory_s / REFERENCE.memory_s)

    def at_best(self, other):
        """The lesser of each time: measurements, too, are the least of several runs."""
        return Calibration(*map(min, astuple(self), astuple(other)))


REFERENCE = Calibration(arithmetic_s=0.0187, memory_s=0.0141, messages_s=0.0220)
"""Of a machine of the kind of docs/measured.md (AMD EPYC, 2 cores), least of many runs: slowness 1. Its time
for messages was not measured there, but follows from one program: see README.md."""


def calibrate():
    """Do the fixed work now; takes about 0.6 s.

    Raises:
        NotAvailable: its program has not been built.
    """
    command = [executable("calibration", "f1tenth_bench"), "--benchmark_format=json"]
    runs = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)["benchmarks"]
    return Calibration(*(_least(runs, name) for name in ("arithmetic", "memory", "messages")))


def _least(runs, name):
    """Processor time of the shortest run of a benchmark, s."""
    single = [run for run in runs if run["run_type"] == "iteration"]
    return min(run["cpu_time"] for run in single if run["name"].startswith(name)) / 1e3
