"""When processes are at rest: all that they were given is handled."""

import itertools
import math
import os
import subprocess
import sys
import threading
import time

import pytest
from f1tenth_judge.drivers.rest import ProcessorUse, Rest, marked_processes, processor_use
from patience import wait_for

# Answers each line after some work, in another thread than the one that reads it.
WORKER = """
import queue, sys, threading
inbox = queue.Queue()
def work():
    while True:
        count = inbox.get()
        print(sum(range(count)), flush=True)
threading.Thread(target=work, daemon=True).start()
print("ready", flush=True)
for line in sys.stdin:
    inbox.put(int(line))
"""
# Answers each line, but sleeps for a moment before, as rospy does between two subscribers.
NAPPER = """
import sys, time
print("ready", flush=True)
for line in sys.stdin:
    time.sleep(0.002)
    print(sum(range(int(line))), flush=True)
"""
# Looks every millisecond whether there is a line, as a ros::Rate and a ros::Timer look at simulated time.
POLLER = """
import queue, sys, threading, time
inbox, never = queue.SimpleQueue(), threading.Condition()
def work():
    while True:
        {wait}
        while not inbox.empty():
            print(sum(range(inbox.get())), flush=True)
threading.Thread(target=work, daemon=True).start()
print("ready", flush=True)
for line in sys.stdin:
    inbox.put(int(line))
"""
# A thread for each line, which ends with it.
STARTER = """
import sys, threading
print("ready", flush=True)
for line in sys.stdin:
    threading.Thread(target=lambda: print(sum(range(int(line))), flush=True)).start()
"""
LIKE_A_RATE = POLLER.format(wait="time.sleep(0.001)")
LIKE_A_TIMER = POLLER.format(wait="\n        with never: never.wait(0.001)")


@pytest.fixture
def start():
    """Starts a Python program with pipes."""
    running = []

    def run(program, **environment):
        pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
        process = subprocess.Popen(
            [sys.executable, "-c", program], env={**os.environ, **environment}, text=True, **pipes
        )
        running.append(process)
        return process

    yield run
    for process in running:
        process.kill()
        process.communicate()


def test_processes_are_found_by_their_mark_with_those_that_they_started(start):
    child = (
        "import subprocess, sys; p = subprocess.Popen(['sleep', '600']); print(p.pid, flush=True); p.wait()"
    )
    one, other = start(child, COLOUR="red 7"), start(child, COLOUR="red 77")
    pids = {one.pid, int(one.stdout.readline())}
    other.stdout.readline()
    assert marked_processes("COLOUR=red 7") == pids
    for each in pids:
        os.kill(each, 9)
    one.wait()
    assert wait_for(lambda: not marked_processes("COLOUR=red 7"))
    os.kill(next(iter(marked_processes("COLOUR=red 77") - {other.pid})), 9)


# The kernel tells nothing of the environment of a process that is about to begin its program.
SPAWNER = """
import os, subprocess
from f1tenth_judge.drivers import rest
for _ in range(30):
    child = subprocess.Popen(["sleep", "600"])
    rest._all_processes = lambda: iter([child.pid, os.getpid()])  # at once
    found = rest.marked_processes("COLOUR=red 7")
    child.kill()
    os.waitid(os.P_PID, child.pid, os.WEXITED | os.WNOWAIT)
    print(found == {os.getpid(), child.pid}, rest.marked_processes("COLOUR=red 7") == {os.getpid()})
    child.wait()
"""


def test_process_is_found_before_its_program_has_begun(start):
    spawner = start(SPAWNER, COLOUR="red 7")
    assert spawner.stdout.read().splitlines() == ["True True"] * 30


def learn(rest, pid):
    """Who polls, from a moment without anything to do."""
    before, began = processor_use([pid]), time.monotonic()
    time.sleep(0.1)
    rest.learn(before, processor_use([pid]), time.monotonic() - began)


@pytest.mark.parametrize("program", [WORKER, NAPPER, STARTER, LIKE_A_RATE, LIKE_A_TIMER])
def test_answer_is_there_whenever_rest_is_reached(start, program):
    worker = start(program)
    assert worker.stdout.readline() == "ready\n"
    os.set_blocking(worker.stdout.fileno(), False)
    rest = Rest()
    learn(rest, worker.pid)
    for count in range(1, 200):
        worker.stdin.write(f"{count * 1000}\n")
        worker.stdin.flush()
        rest.renew()
        assert wait_for(lambda: rest.is_reached([worker.pid]))
        assert worker.stdout.readline() == f"{sum(range(count * 1000))}\n"


@pytest.mark.parametrize(
    ("switches", "waited", "polls"), [(35, 0.0, True), (33, 0.0, False), (8, 0.08, True), (7, 0.09, False)]
)
def test_who_polls_is_told_by_how_often_it_could(switches, waited, polls):
    rest = Rest()
    begin, end = (ProcessorUse(False, 0, 1.0, 100), ProcessorUse(False, 9, 1.0 + waited, 100 + switches))
    rest.learn({(1, 2): begin}, {(1, 2): end}, 0.1)
    assert ((1, 2) in rest._pollers) == polls


class Told:
    """What the kernel tells of a thread; each question takes a moment."""

    def __init__(self, moments):
        self._moments = moments
        self.woken = self.works = math.inf  # moments; its work takes none

    def runs(self):
        return self.woken <= next(self._moments) < self.works

    def switches(self):
        return b"8" if next(self._moments) >= self.works else b"7"


@pytest.mark.parametrize("works", range(12))
@pytest.mark.parametrize("later", range(1, 5))
def test_work_that_is_handed_on_between_two_questions_is_not_overlooked(monkeypatch, works, later):
    moments, rest = itertools.count(), Rest()
    first, second = Told(moments), Told(moments)
    monkeypatch.setattr(rest, "_list", lambda pids: None)
    monkeypatch.setattr(rest, "_wait_of", lambda thread: b"futex_wait_queue")
    rest._threads = {(1, 1): second, (1, 2): first}
    assert rest.is_reached([1])
    rest.renew()
    first.woken = next(moments)
    first.works = second.woken = first.woken + works
    second.works = second.woken + later
    assert any(rest.is_reached([1]) for _ in range(20))
    assert next(moments) > second.works


def test_who_computes_is_not_at_rest(start):
    busy = start("print('ready', flush=True)\nwhile True: pass")
    busy.stdout.readline()
    rest = Rest()
    assert not any(rest.is_reached([busy.pid]) for _ in range(100))


def test_who_sleeps_for_long_is_at_rest(start):
    sleeper = start("import time\nprint('ready', flush=True)\nwhile True: time.sleep(600)")
    sleeper.stdout.readline()
    rest = Rest()
    assert wait_for(lambda: rest.is_reached([sleeper.pid]))
    rest.renew()
    assert rest.is_reached([sleeper.pid])


def test_who_has_ended_is_at_rest(start):
    process = start("pass")
    process.wait()
    assert Rest().is_reached([process.pid])


def test_one_thread_may_be_left_out():
    assert not Rest().is_reached([os.getpid()])
    assert wait_for(lambda: Rest(threading.get_native_id()).is_reached([os.getpid()]))
