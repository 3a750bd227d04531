"""SIGINT at any moment of a command."""

import dataclasses
import os
import random
import shutil
import signal
import time
from collections.abc import Sequence
from pathlib import Path

from f1tenth_studies.faults.catalogue import SCENARIO
from f1tenth_studies.faults.victim import MOST_SECONDS, Ending, Victim

_LONGEST = 600.0  # wall s
COMMANDS = {
    "scenario run": ("run", "circuit1"),
    "scenario race": ("race", "circuit1"),
    "scenario sweep": ("sweep", "circuit1", "--vary", "seed=1:3"),
    "scenario report": ("report",),
}
_BEFORE = {"scenario report": ("run", "circuit1")}  # what makes the results that a command reads


@dataclasses.dataclass(frozen=True)
class Interrupts:
    """The outcomes of many interrupts."""

    command: str
    endings: Sequence[Ending]

    @property
    def slowest(self) -> float:
        """The longest time until none of its processes ran, wall s."""
        return max(each.seconds for each in self.endings)

    @property
    def problems(self) -> list[str]:
        """What is wrong: another exit code, a traceback, a process that keeps running."""
        found = []
        for each in self.endings:
            if each.exit_code not in (0, 128 + signal.SIGINT, -signal.SIGINT):
                found.append(f"exit code {each.exit_code}")
            if "Traceback" in each.said:
                found.append("a traceback")
            if each.seconds > MOST_SECONDS:
                found.append(f"all gone only after {each.seconds:.1f} s")
        return sorted(set(found))


def interrupt(name: str, count: int, folder: Path, seed: int = 1) -> Interrupts:
    """Interrupt a command at `count` random moments of its life."""
    command = (*SCENARIO, *COMMANDS[name])
    before = folder / "before" / "results"
    before.mkdir(parents=True)
    if name in _BEFORE:
        _run((*SCENARIO, *_BEFORE[name]), before, _LONGEST)

    def run(label: str, seconds: float) -> tuple[Ending, float]:
        results = shutil.copytree(before, folder / label / "results")
        return _run(command, results, seconds)

    duration = run("whole", _LONGEST)[1]
    moments = random.Random(seed)
    endings = [run(f"{number:02}", moments.uniform(0.0, duration))[0] for number in range(count)]
    return Interrupts(name, endings)


def _run(command: Sequence[str], results: Path, seconds: float) -> tuple[Ending, float]:
    """Run it for some time (wall s), then interrupt it; also returns how long it ran."""
    begun = time.monotonic()
    with Victim([*command, "--results", str(results)], results, results.parent / "said") as victim:
        victim.wait_for(lambda: False, seconds)
        ran = time.monotonic() - begun
        if victim.process.poll() is None:
            os.killpg(victim.process.pid, signal.SIGINT)  # as a terminal does it
        return victim.end(30.0), ran
