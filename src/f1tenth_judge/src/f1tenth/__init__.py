"""Races and scenarios of the F1/10 car from Python.

    import f1tenth

    run = f1tenth.race("circuit3", planner="my_planner.py:MyPlanner", laps=3, seed=4)
    assert run.verdict == "success"
    assert run.trajectory["clearance"].min() > 0.15

In a test of pytest, the fixture `f1tenth` has the same functions.
"""

from f1tenth_judge.api.run import COLUMNS, Run
from f1tenth_judge.api.runs import Runs

race, run = Runs().race, Runs().run

__all__ = ["COLUMNS", "Run", "Runs", "race", "run"]
