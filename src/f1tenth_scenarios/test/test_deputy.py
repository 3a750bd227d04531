"""When the deputy lets a period be over, and whom it finds not to fit lockstep."""

import subprocess
import sys
import time

import pytest
from f1tenth_scenarios.drivers import deputy
from f1tenth_scenarios.drivers.deputy import Deputy
from f1tenth_scenarios.errors import MisfitError

PATIENCE = 1.0  # s
MARK = "F1TENTH_TEST_DRIVER=robot1 of a test"
IDLE = "print('ready', flush=True); import time; time.sleep(600)"
LOADING = """
import time
print('ready', flush=True)
end = time.monotonic() + 0.5
while time.monotonic() < end: pass
time.sleep(600)
"""
BUSY = "print('ready', flush=True)\nwhile True: pass"


class FakeWorld:
    """Notes what the deputy does; the driver sends commands as its script says: before rest, and after."""

    def __init__(self, before=1, after=0, listens=True):
        self.done = []
        self._listens = listens
        self._count, self._before, self._after = 0, before, after
        self._asked = 0

    def connections(self):
        return "steady"

    def commands(self):
        self._asked += 1
        self._count += self._before if self._asked % 2 else self._after
        return self._count

    def has_listener(self):
        return self._listens

    def publish_scans(self):
        self.done.append("scan")

    def publish_clock(self, stamp):
        self.done.append(stamp)

    def is_over(self):
        return False


@pytest.fixture
def driver(monkeypatch):
    """Starts a process that plays the driver; everything in the deputy goes a little faster."""
    for name in ("_PACE", "_CONNECTING"):
        monkeypatch.setattr(deputy, name, 0.001)
    running = []

    def start(program=IDLE):
        name, _, value = MARK.partition("=")
        process = subprocess.Popen(
            [sys.executable, "-c", program], env={name: value}, stdout=subprocess.PIPE, text=True
        )
        running.append(process)
        process.stdout.readline()
        return process

    yield start
    for process in running:
        process.kill()
        process.communicate()


@pytest.fixture
def hurried(monkeypatch):
    """The deputy gives a driver less time to load."""
    monkeypatch.setattr(deputy, "_LOADING", 0.2)
    monkeypatch.setattr(deputy, "_SPINNING", 0.1)


def test_scan_comes_before_the_time(driver):
    driver()
    world = FakeWorld()
    Deputy(world, MARK, PATIENCE).act("now")
    assert world.done == ["scan", "now"]


def test_driver_that_fits_has_started_up_after_some_periods(driver):
    driver()
    world = FakeWorld()
    one = Deputy(world, MARK, PATIENCE)
    for period in range(40):
        one.act(period)
    assert world.done[-2:] == ["scan", 39]


def test_who_sends_commands_while_time_stands_still_does_not_fit(driver):
    driver()
    one = Deputy(FakeWorld(before=0, after=1), MARK, PATIENCE)
    one.act(0)
    one.act(1)
    with pytest.raises(MisfitError, match="by the wall clock, while simulated time stands still"):
        one.act(2)


def test_who_never_rests_does_not_fit_once_it_sends_commands(driver, hurried):
    driver(BUSY)
    with pytest.raises(MisfitError, match="its threads do not come to rest within 0.2 s"):
        Deputy(FakeWorld(), MARK, PATIENCE).act("now")


def test_who_never_rests_gets_a_scan_but_no_time(driver, hurried):
    driver(BUSY)
    world = FakeWorld(before=0)
    with pytest.raises(MisfitError, match="its threads do not come to rest within 1 s"):
        Deputy(world, MARK, PATIENCE).act("now")
    assert world.done == ["scan"]


def test_no_scan_is_lost_on_who_has_not_subscribed_yet(driver, hurried):
    driver(BUSY)
    world = FakeWorld(before=0, listens=False)
    with pytest.raises(MisfitError):
        Deputy(world, MARK, PATIENCE).act("now")
    assert world.done == []


def test_time_waits_for_who_loads_long(driver, hurried):
    driver(LOADING)
    world = FakeWorld(before=0, listens=False)
    began = time.monotonic()
    Deputy(world, MARK, 30.0).act("now")
    assert world.done == ["scan", "now"]
    assert time.monotonic() - began > deputy._LOADING


def test_who_has_loaded_long_may_answer_just_before_it_rests(driver, hurried, monkeypatch):
    monkeypatch.setattr(deputy, "_SPINNING", 5.0)
    driver(LOADING)
    Deputy(FakeWorld(), MARK, 30.0).act("now")


def test_time_stands_still_once_when_a_process_has_ended(driver):
    slept = []
    driver()
    victim = driver()
    one = Deputy(FakeWorld(), MARK, PATIENCE, sleep=slept.append)
    one.act(0)
    victim.kill()
    victim.wait()
    for period in range(1, 4):
        one.act(period)
    assert slept.count(deputy._NOTICING) == 1
