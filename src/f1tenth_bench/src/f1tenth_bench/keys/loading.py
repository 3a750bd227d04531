"""load_ms: load of circuit_detailed."""

import subprocess
import sys

from f1tenth_bench.benchmark import Measured, benchmark
from f1tenth_bench.places import circuit_file

# The first load of a process, which also works out libsdformat's description of SDF, and the next one.
SCRIPT = """
import sys, time
import f1tenth_sim2d
for _ in range(2):
    before = time.process_time()
    f1tenth_sim2d.load_world(sys.argv[1])
    print(1e3 * (time.process_time() - before))
"""


@benchmark("load_ms", "ms", at_most=200)
def load_ms():
    """The first load in a process of its own, the least of five processes."""
    loads = [_loads_of_a_process() for _ in range(5)]
    first, second = min(first for first, _ in loads), min(second for _, second in loads)
    return Measured(first, {"second_load": second})


def _loads_of_a_process():
    command = [sys.executable, "-c", SCRIPT, str(circuit_file("circuit_detailed"))]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return tuple(float(line) for line in output.split())
