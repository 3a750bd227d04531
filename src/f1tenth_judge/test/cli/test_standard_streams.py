"""The command with its standard streams closed: nothing that it opens takes their places."""

import subprocess
import sys

import pytest

PROGRAM = """
import os, sys
from f1tenth_judge.cli.standard_streams import open_standard_streams
open_standard_streams()
print("said"); print("complained", file=sys.stderr); sys.stdout.flush()
first = os.open(sys.argv[1], os.O_CREAT | os.O_WRONLY)
os.write(first, b"%d" % first)
subprocess = __import__("subprocess").run(["sh", "-c", "read line; echo said; echo complained >&2"])
"""


@pytest.mark.parametrize("closed", ["<&-", ">&-", "2>&-", "<&- >&-", "<&- >&- 2>&-"])
def test_file_that_is_opened_gets_no_stream_that_was_closed(tmp_path, closed):
    command = ["bash", "-c", f'"$@" {closed}', "bash", sys.executable, "-c", PROGRAM, str(tmp_path / "file")]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert int((tmp_path / "file").read_text(encoding="utf-8")) > 2
    assert done.stdout == ("" if ">&-" in closed.split() else "said\nsaid\n")
    assert done.stderr == ("" if "2>&-" in closed else "complained\ncomplained\n")


def test_progress_needs_no_stream(monkeypatch):
    from f1tenth_judge.cli.standard_streams import open_standard_streams
    from f1tenth_judge.results.console import CountLine, ProgressLine

    monkeypatch.setattr(sys, "stderr", None)
    open_standard_streams()
    with sys.stderr:
        ProgressLine("one").update(1.0, 1.0)
        CountLine("all", 2).update(True)
