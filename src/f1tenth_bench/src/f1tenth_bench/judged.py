"""Runs of the command f1tenth, which are judged."""

import shutil
import subprocess
from pathlib import Path

from f1tenth_judge.record.files import RESULT_FILE
from f1tenth_judge.results.result_file import read_result

from f1tenth_bench.benchmark import NotAvailable

_JUDGED = (0, 1)  # exit codes of a run that left a result


def judged(folder, name, *arguments):
    """What result.json says of a run whose results go to a folder, under a name.

    Raises:
        NotAvailable: there is no command, or it left no result.
    """
    command = shutil.which("f1tenth")
    if not command:
        raise NotAvailable("no command f1tenth; source the workspace's setup.bash")
    options = ("--results", str(folder), "--name", name)
    done = subprocess.run([command, *arguments, *options], capture_output=True, text=True, check=False)
    # Any other code leaves the result of an earlier run where it is.
    if done.returncode not in _JUDGED:
        raise NotAvailable(f"{name} has no result: {done.stderr.strip()}")
    return read_result(Path(folder) / name / RESULT_FILE)
