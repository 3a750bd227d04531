"""The example that drives by the camera alone gets round."""

import subprocess
import sys
from pathlib import Path

EXAMPLE = Path(__file__).parents[2] / "examples" / "free_floor.py"


def test_it_drives_a_lap_without_a_contact():
    ended = subprocess.run([sys.executable, EXAMPLE, "circuit1", "60"], capture_output=True, text=True)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert "laps 1, contact 0" in ended.stdout
