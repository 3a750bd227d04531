"""What `make` refuses before it builds anything."""

import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def test_race_on_a_circuit_that_is_not_there_is_refused_before_building(tmp_path):
    environment = {key: value for key, value in os.environ.items() if key != "ROS_PACKAGE_PATH"}
    command = ["make", "--no-print-directory", "race", "CIRCUIT=circuit9", f"OUT={tmp_path / 'out'}"]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    message, _ = done.stderr.splitlines()
    assert message.startswith(
        "CIRCUIT=circuit9: no such file, and no such circuit; there are: circuit1 circuit2 "
    )
    assert done.stdout == ""
    assert list(tmp_path.iterdir()) == []
