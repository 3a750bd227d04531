"""A program in the place of the command `f1tenth`: leaves a result for each run, and a note that it ran."""

import sys

import pytest
from f1tenth_judge.batch import jobs

# `seed=13` is bad luck; a file `silent` keeps runs from writing anything, as if they were interrupted early.
PROGRAM = """
import json, pathlib, sys
arguments = sys.argv[1:]
folder = pathlib.Path(arguments[arguments.index("--results") + 1])
settings = [value for option, value in zip(arguments, arguments[1:]) if option == "--set"]
names = [value for option, value in zip(arguments, arguments[1:]) if option == "--name"]
root = pathlib.Path(__file__).parent
with open(root / "log", "a") as log:
    log.write((names or [folder.name])[0] + "\\n")
if "seed=13" in settings:
    sys.exit("bad luck")
if (root / "silent").exists():
    sys.exit(int((root / "silent").read_text()))
values = dict(each.split("=") for each in settings)
lap = 10.0 + float(values.get("mu", 0)) + len((root / "log").read_text()) * (root / "drift").exists()
result = {"verdict": "success", "passed": values.get("seed") != "2", "settings": settings, "culprit": None,
          "times": {"finish": 1.0, "lap_time": lap, "cost": 3.0}, "minimum_clearance": 0.25,
          "trajectory_hash": str(lap),
          "reason": "ok", "scenario": "sample", "criteria": [],
          "cars": {"robot1": {"planner": "race", "driver": "launch file", "lap_times": [lap]}},
          "contacts": [], "interventions": [], "winner": None, "versions": {"driver_commits": {}}}
target = folder / (names or [pathlib.Path(arguments[-1]).stem])[0]
target.mkdir(parents=True, exist_ok=True)
(target / "result.json").write_text(json.dumps(result))
print(arguments[-1], "ran")
sys.exit(0 if result["passed"] else 1)
"""


class FakeScenario:
    """The program and what is known of its runs."""

    def __init__(self, folder):
        self.folder = folder
        self.path = folder / "program.py"
        self.path.write_text(PROGRAM, encoding="utf-8")

    def runs(self):
        """The names of the results folders, in the order of the runs."""
        log = self.folder / "log"
        return log.read_text(encoding="utf-8").split() if log.exists() else []

    def falls_silent(self, exit_code):
        """From now on runs end with an exit code and leave nothing."""
        (self.folder / "silent").write_text(str(exit_code), encoding="utf-8")

    def drifts(self):
        """From now on no run is like the one before."""
        (self.folder / "drift").touch()


@pytest.fixture
def program(tmp_path, monkeypatch):
    (tmp_path / "program").mkdir()
    fake = FakeScenario(tmp_path / "program")
    monkeypatch.setattr(jobs, "PROGRAM", (sys.executable, str(fake.path)))
    return fake
