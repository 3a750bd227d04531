"""Several commands at the same time."""

import signal
import sys

import pytest
from f1tenth_scenarios.batch.several import run_several
from f1tenth_scenarios.stop_request import StopRequest

from f1tenth_scenarios import cli

# Says that it is there, and ends with its argument as exit code when the others are there too.
MEETING = """
import pathlib, sys, time
folder, needed, code = pathlib.Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
(folder / sys.argv[3]).touch()
while len(list(folder.iterdir())) < needed:
    time.sleep(0.01)
print("code", code)
sys.exit(code)
"""


def meet(folder, needed, codes, jobs, stop=None):
    commands = [[sys.executable, "-c", MEETING, str(folder), str(needed), str(code)] for code in codes]
    found = []
    run_several(commands, jobs, stop or StopRequest(), lambda *ended: found.append(ended))
    return sorted(found)


def test_commands_run_at_the_same_time_and_their_output_is_kept_apart(tmp_path):
    assert meet(tmp_path, 3, [0, 1, 7], jobs=3) == [(0, "code 0\n"), (1, "code 1\n"), (7, "code 7\n")]


def test_one_at_a_time_writes_where_this_process_writes(tmp_path, capfd):
    assert meet(tmp_path, 1, [0, 3], jobs=1) == [(0, ""), (3, "")]
    assert capfd.readouterr().out == "code 0\ncode 3\n"


def test_signal_ends_those_that_run_and_starts_no_more(tmp_path):
    with StopRequest().listening() as stop:
        raise_when_running(tmp_path, 2)
        assert [code for code, _ in meet(tmp_path, 9, [0, 1, 2, 3], jobs=2, stop=stop)] == [
            -signal.SIGTERM,
            -signal.SIGTERM,
        ]
    assert len(list(tmp_path.iterdir())) == 2


def raise_when_running(folder, count):
    """A SIGTERM for this process as soon as so many commands have said that they are there."""

    def look(_number, _frame):
        if len(list(folder.iterdir())) < count:
            signal.setitimer(signal.ITIMER_REAL, 0.05)
        else:
            signal.raise_signal(signal.SIGTERM)

    signal.signal(signal.SIGALRM, look)
    signal.setitimer(signal.ITIMER_REAL, 0.05)


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["circuit1", "--jobs", "0"], "--jobs is 0, must be at least 1"),
        ([], "run needs either names of scenarios or --all"),
        (["--all", "circuit1"], "run needs either names of scenarios or --all"),
    ],
)
def test_wrong_options_are_answered(arguments, answer, capsys):
    assert cli.main(["run", *arguments]) == 2
    assert capsys.readouterr().err == f"scenario: {answer}\n"
