"""Whatever a run started is gone when it is over."""

import os
import signal
import subprocess
import sys

import psutil
import pytest
from f1tenth_judge.run.processes import ProcessTree
from patience import PATIENCE, wait_for

SLEEP = "import time; time.sleep(600)"
IGNORE = "import signal; [signal.signal(s, signal.SIG_IGN) for s in (signal.SIGINT, signal.SIGTERM)]"


def start(tmp_path, program, **environment):
    return ProcessTree([sys.executable, "-c", program], tmp_path / "log", environment)


def starts_child(folder, program, own_session=False):
    """A program that starts another one, which writes its process id as soon as it can be told to end."""
    child = (
        "import os, pathlib\n"
        f"path = pathlib.Path({str(folder)!r})\n"
        "(path / 'new').write_text(str(os.getpid()))\n"
        "(path / 'new').rename(path / 'pid')\n"
        f"{program}"
    )
    return (
        "import subprocess, sys\n"
        f"child = subprocess.Popen([sys.executable, '-c', {child!r}], start_new_session={own_session})\n"
    )


def pid_of_child(folder):
    return int(wait_for(lambda: (folder / "pid").exists() and (folder / "pid").read_text()))


def is_gone(pid):
    try:
        return psutil.Process(pid).status() in (psutil.STATUS_ZOMBIE, psutil.STATUS_DEAD)
    except psutil.NoSuchProcess:
        return True


def test_output_goes_to_the_log_file(tmp_path):
    tree = start(tmp_path, "import sys; print('out'); print('err', file=sys.stderr); sys.exit(3)")
    assert wait_for(lambda: tree.exit_code() is not None)
    assert tree.exit_code() == 3
    assert set((tmp_path / "log").read_text().split()) == {"out", "err"}


def test_environment_is_passed_on(tmp_path):
    tree = start(tmp_path, "import os; print(os.environ['COLOUR'])", COLOUR="red")
    wait_for(lambda: tree.exit_code() is not None)
    assert (tmp_path / "log").read_text() == "red\n"


def test_child_may_end_what_it_started(tmp_path):
    program = (
        "import pathlib, time\n"
        f"path = pathlib.Path({str(tmp_path)!r})\n"
        "try:\n    (path / 'ready').touch(); time.sleep(600)\n"
        "except KeyboardInterrupt:\n    (path / 'ended').touch()"
    )
    tree = start(tmp_path, program)
    wait_for((tmp_path / "ready").exists)
    tree.stop(PATIENCE)
    assert (tmp_path / "ended").exists()
    assert tree.exit_code() == 0


@pytest.mark.parametrize("own_session", [False, True])
def test_grandchild_is_ended(tmp_path, own_session):
    tree = start(tmp_path, starts_child(tmp_path, SLEEP, own_session) + SLEEP)
    pid = pid_of_child(tmp_path)
    tree.stop(0.1)
    assert is_gone(pid)


def test_grandchild_that_outlived_its_parent_is_ended(tmp_path):
    tree = start(tmp_path, starts_child(tmp_path, SLEEP, own_session=True))
    pid = pid_of_child(tmp_path)
    wait_for(lambda: tree.exit_code() is not None)
    assert not is_gone(pid)
    tree.stop(0.1)
    assert is_gone(pid)


@pytest.mark.parametrize("parent_ends", [False, True])
def test_daemon_that_throws_its_environment_away_is_ended(tmp_path, parent_ends):
    child = (
        "import os, pathlib, time\n"
        "if os.fork(): os._exit(0)\n"
        "os.setsid()\n"
        "if os.fork(): os._exit(0)\n"
        f"path = pathlib.Path({str(tmp_path)!r})\n"
        "(path / 'new').write_text(str(os.getpid())); (path / 'new').rename(path / 'pid'); time.sleep(600)\n"
    )
    program = f"import subprocess, sys; subprocess.run([sys.executable, '-c', {child!r}], env={{}})\n"
    tree = start(tmp_path, program + ("" if parent_ends else SLEEP))
    pid = pid_of_child(tmp_path)
    if parent_ends:
        wait_for(lambda: tree.exit_code() is not None)
    tree.stop(0.1)
    assert is_gone(pid)


def test_process_that_ignores_signals_is_killed(tmp_path):
    tree = start(tmp_path, f"{IGNORE}\nprint('deaf', flush=True)\n{SLEEP}")
    wait_for(lambda: (tmp_path / "log").read_text())
    tree.stop(0.1, last_grace=0.1)
    assert tree.exit_code() == -signal.SIGKILL


def test_stopped_processes_end_in_order(tmp_path):
    ends_in_order = (
        "import pathlib, sys, time\n"
        f"path = pathlib.Path({str(tmp_path)!r})\n"
        "try:\n    (path / 'ready').touch(); time.sleep(600)\n"
        "except KeyboardInterrupt:\n    (path / 'ended').touch()"
    )
    passes_on = (
        "import pathlib, signal\n"
        "signal.signal(signal.SIGINT, lambda *_: child.send_signal(signal.SIGINT))\n"
        f"(pathlib.Path({str(tmp_path)!r}) / 'passes_on').touch()\n"
        "sys.exit(child.wait())"
    )
    tree = start(tmp_path, starts_child(tmp_path, ends_in_order, own_session=True) + passes_on)
    child = psutil.Process(pid_of_child(tmp_path))
    wait_for((tmp_path / "ready").exists)
    wait_for((tmp_path / "passes_on").exists)
    child.suspend()
    child.parent().suspend()
    tree.stop(PATIENCE)
    assert (tmp_path / "ended").exists()
    assert tree.exit_code() == 0


def test_a_stopped_helper_of_this_process_goes_on(tmp_path):
    with subprocess.Popen(["sleep", "600"]) as helper:
        helper.send_signal(signal.SIGSTOP)
        stopped = psutil.Process(helper.pid)
        wait_for(lambda: stopped.status() == psutil.STATUS_STOPPED)
        start(tmp_path, SLEEP).stop(0.1)
        assert wait_for(lambda: stopped.status() != psutil.STATUS_STOPPED)
        helper.kill()


def test_what_a_killed_child_left_behind_is_told_to_end(tmp_path):
    tree = start(tmp_path, starts_child(tmp_path, SLEEP, own_session=True) + SLEEP)
    left = pid_of_child(tmp_path)
    psutil.Process(left).parent().kill()
    wait_for(lambda: tree.exit_code() is not None)
    tree.interrupt(left, PATIENCE)
    assert is_gone(left)
    tree.stop(0.1)


def test_process_that_is_waited_for_may_end_before_the_others(tmp_path):
    program = (
        "import pathlib, subprocess, sys\n"
        f"path = pathlib.Path({str(tmp_path)!r})\n"
        "child = subprocess.Popen(['sleep', '600'])\n"
        f"{IGNORE}\n"
        "(path / 'new').write_text(str(child.pid))\n"
        "(path / 'new').rename(path / 'pid')\n"
    )
    tree = start(tmp_path, program + SLEEP)
    pid = pid_of_child(tmp_path)
    tree.interrupt(pid, PATIENCE)
    assert is_gone(pid)
    assert tree.exit_code() is None
    tree.stop(0.1, last_grace=0.1)
    assert tree.exit_code() == -signal.SIGKILL


def test_start_of_a_process_is_before_all_that_it_does():
    program = (
        "import time; first = time.monotonic()\n"
        "from f1tenth_judge.run.processes import process_start; print(first - process_start())"
    )
    said = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert 0.0 <= float(said.stdout) + 0.01 < PATIENCE


def test_stopping_twice_does_no_harm(tmp_path):
    tree = start(tmp_path, SLEEP)
    tree.stop(0.5)
    tree.stop(0.5)


def test_other_trees_are_left_alone(tmp_path):
    (tmp_path / "one").mkdir()
    (tmp_path / "two").mkdir()
    one, two = start(tmp_path / "one", SLEEP), start(tmp_path / "two", SLEEP)
    one.stop(0.5)
    assert two.exit_code() is None
    two.stop(0.5)


def test_child_ends_when_its_parent_is_killed(tmp_path):
    # Not Python: while its interpreter starts up, a SIGINT can get lost. And setpriv hears of no end
    # before it has asked to be told, which it has when the program is what it was told to start.
    program = (
        "import pathlib, sys, time\n"
        "from f1tenth_judge.run.processes import ProcessTree\n"
        f"path = pathlib.Path({str(tmp_path)!r})\n"
        "tree = ProcessTree(['sleep', '600'], path / 'log', {})\n"
        "import psutil\n"
        "pid = psutil.Process().children()[0].pid\n"
        "(path / 'new').write_text(str(pid)); (path / 'new').rename(path / 'pid'); time.sleep(600)\n"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    with subprocess.Popen([sys.executable, "-c", program], env=environment) as parent:
        pid = pid_of_child(tmp_path)
        wait_for(lambda: psutil.Process(pid).name() == "sleep")
        parent.kill()
    wait_for(lambda: is_gone(pid))
