"""What a driver is granted of wall time does not count the time for which others had the processors."""

import ctypes
import os
import signal
import subprocess
import sys
import time

import pytest
from f1tenth_judge.drivers.granted_time import GrantedTime
from f1tenth_judge.drivers.rest import ProcessorUse, processor_use

PTRACE_ATTACH = 16
PIDS = [7]
ASLEEP = ProcessorUse(False, 0, 0.0, 0)


class Machine:
    """A clock, and what threads have had."""

    def __init__(self):
        self.wall = 100.0
        self.threads = {(7, 7): ASLEEP, (7, 8): ASLEEP._replace(waited=3.0)}
        self.time = GrantedTime(lambda: self.wall, lambda pids: dict(self.threads) if pids == PIDS else {})

    def pass_by(self, seconds, thread=7, **changes):
        """Meanwhile a thread has become as these changes say."""
        self.wall += seconds
        self.threads[7, thread] = self.threads.get((7, thread), ASLEEP)._replace(**changes)
        return self.time.now(PIDS)


@pytest.fixture
def machine():
    made = Machine()
    made.pass_by(1.0)
    return made


def test_on_an_idle_machine_it_is_wall_time(machine):
    times = [machine.pass_by(0.1, is_ready=True, ran=number / 10) for number in range(1, 6)]
    assert times == pytest.approx([101.1, 101.2, 101.3, 101.4, 101.5])


def test_what_it_has_waited_for_a_processor_does_not_count(machine):
    assert machine.pass_by(1.0, waited=0.75) == pytest.approx(101.25)
    assert machine.pass_by(1.0, thread=8, waited=3.25, ran=0.5) == pytest.approx(102.0)


def test_of_threads_that_run_side_by_side_the_part_counts_in_which_they_had_one(machine):
    machine.threads[7, 8] = machine.threads[7, 8]._replace(waited=3.5, ran=0.5)
    assert machine.pass_by(1.0, waited=1.0) == pytest.approx(101.25)


def test_who_is_ready_and_has_not_run_since_waits_until_the_kernel_counts_it(machine):
    assert machine.pass_by(0.5, is_ready=True) == pytest.approx(101.5)
    assert machine.pass_by(0.5) == pytest.approx(101.5)
    assert machine.pass_by(0.5) == pytest.approx(101.5)
    assert machine.pass_by(0.5, waited=1.25, ran=0.25) == pytest.approx(101.75)


def test_threads_are_looked_at_now_and_then(machine):
    assert machine.pass_by(0.015, waited=0.015) == pytest.approx(101.015)
    assert machine.pass_by(0.015) == pytest.approx(101.015)
    assert machine.pass_by(0.1) == pytest.approx(101.115)


def test_it_never_goes_back(machine):
    assert machine.pass_by(0.015) == pytest.approx(101.015)
    assert machine.pass_by(0.015, waited=2.0) == pytest.approx(101.015)
    assert machine.pass_by(1.0) == pytest.approx(102.0)


def test_what_a_new_thread_waited_before_it_was_seen_does_not_count(machine):
    assert machine.pass_by(0.25, thread=9, waited=30.0) == pytest.approx(101.25)
    assert machine.pass_by(0.25, thread=9, waited=30.25) == pytest.approx(101.25)


def test_kernel_tells_how_long_who_shares_a_processor_has_waited():
    program = "import os\nos.sched_setaffinity(0, {min(os.sched_getaffinity(0))})\nwhile True: pass\n"
    spinning = [subprocess.Popen([sys.executable, "-c", program]) for _ in range(3)]
    try:
        pids = [each.pid for each in spinning]
        end = time.monotonic() + 20.0
        while sum(use.waited for use in processor_use(pids).values()) < 0.2:
            assert time.monotonic() < end
            time.sleep(0.05)
        assert all(use.is_ready and use.ran and use.switches for use in processor_use(pids).values())
    finally:
        for each in spinning:
            each.kill()
            each.wait()


def test_while_nobody_looks_a_second_counts_at_most(machine):
    assert machine.pass_by(30.0) == pytest.approx(102.0)
    assert machine.pass_by(30.0, waited=29.5) == pytest.approx(102.5)
    assert machine.pass_by(0.5) == pytest.approx(103.0)


def test_who_is_stopped_would_run():
    with subprocess.Popen(["sleep", "600"]) as process:
        process.send_signal(signal.SIGSTOP)
        os.waitpid(process.pid, os.WUNTRACED)
        assert all(use.is_ready for use in processor_use([process.pid]).values())
        process.kill()


def test_who_is_stopped_by_a_debugger_would_run():
    with subprocess.Popen(["sleep", "600"]) as process:
        libc = ctypes.CDLL(None, use_errno=True)
        assert libc.ptrace(PTRACE_ATTACH, process.pid, None, None) == 0
        os.waitid(os.P_PID, process.pid, os.WSTOPPED | os.WNOWAIT)
        assert all(use.is_ready for use in processor_use([process.pid]).values())
        process.kill()


def test_who_is_gone_has_had_nothing():
    assert processor_use([2**22 + 1]) == {}
