#!/usr/bin/env python3
"""Whether the machine's load changes a planner's mode or hash: load_check.py [LOAD [HABIT...]], nightly.

Every habit of nodes/habits.py drives on a machine that does nothing else, and again beside LOAD (30)
processes that compute without a pause. Prints a line for each; exit code 1 if one differs. No test of pytest:
it takes half an hour, and all of the machine.
"""

import contextlib
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

NODES = Path(__file__).resolve().parent / "nodes"
SIMULATED = 3  # s


def habits():
    """Those that there are: methods that Habits calls nothing itself."""
    text = (NODES / "habits.py").read_text(encoding="utf-8")
    return re.findall(r"^    def ((?:[a-z]+_)+[a-z]+)\(self\)", text, re.MULTILINE)


@contextlib.contextmanager
def load(count):
    """So many processes that never sleep."""
    busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(count)]
    try:
        yield
    finally:
        for each in busy:
            each.kill()
            each.wait()


def run(habit):
    """The mode and hash of a run."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            sys.executable,
            "-m",
            "f1tenth_judge",
            "race",
            "circuit5",
            "--planner",
            str(NODES / "habits.launch"),
        ]
        options = ["--arg", f"how:={habit}", "--set", f"limits.timeout={SIMULATED}", "--results", folder]
        subprocess.run([*command, *options], capture_output=True, check=False, cwd=folder)
        result = json.loads(Path(folder, "race_circuit5", "result.json").read_text(encoding="utf-8"))
    mode = "lockstep" if result["lockstep"] and result["repeatable"] else f"not repeatable ({result['note']})"
    return mode if result["verdict"] == "timeout" else result["reason"], result["trajectory_hash"]


def main():
    """Compare; return how many differ, at most 1."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 30
    chosen = sys.argv[2:] or habits()
    idle = {habit: run(habit) for habit in chosen}
    with load(count):
        busy = {habit: (*run(habit), os.getloadavg()[0]) for habit in chosen}
    same = [habit for habit in chosen if busy[habit][:2] == idle[habit] and idle[habit][0] == "lockstep"]
    for habit in chosen:
        mode, found, at = busy[habit]
        words = (
            "the same" if habit in same else f"DIFFERS: {mode} {found}, without load {' '.join(idle[habit])}"
        )
        print(f"{habit}: {words} (load {at:.0f})")
    print(f"{len(same)} of {len(chosen)} habits: lockstep and the same hash with and without load")
    return int(len(same) < len(chosen))


if __name__ == "__main__":
    sys.exit(main())
