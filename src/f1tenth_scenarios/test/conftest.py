"""Fixtures of several tests, which also use the judge's samples."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "f1tenth_judge" / "test"))
from fake_scenario import program  # noqa: E402, F401
