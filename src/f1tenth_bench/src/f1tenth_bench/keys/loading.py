"""load_ms: load of circuit_detailed."""

import subprocess
import sys

from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.places import circuit_file

# The first load of a process and the next one, with the time of the processes that read its meshes.
SCRIPT = """
import resource, sys
import f1tenth_sim2d
def cpu_time():
    usages = [resource.getrusage(of) for of in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)

for _ in range(2):
    before = cpu_time()
    f1tenth_sim2d.load_world(sys.argv[1])
    print(1e3 * (cpu_time() - before))
"""


@benchmark("load_ms", "ms", at_most=15)
def load_ms():
    """The first load in a process of its own, the least of five processes."""
    loads = [_loads_of_a_process() for _ in range(5)]
    first, second = min(first for first, _ in loads), min(second for _, second in loads)
    return Measured(first, {"second_load": second})


def _loads_of_a_process():
    command = [sys.executable, "-c", SCRIPT, str(circuit_file("circuit_detailed"))]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return tuple(float(line) for line in output.split())
