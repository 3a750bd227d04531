"""When the proxy driver lets a period be over, and whom it finds not to fit lockstep."""

import contextlib
import os
import signal
import subprocess
import sys
import threading
import time

import pytest
from f1tenth_judge.drivers import proxy_driver
from f1tenth_judge.drivers.proxy_driver import ProxyDriver
from f1tenth_judge.errors import MismatchError, NotAtRestError

PATIENCE = 1.0  # s, for both
MARK = "F1TENTH_TEST_DRIVER=robot1 of a test"
IDLE = "print('ready', flush=True); import time; time.sleep(600)"
LOADING = """
import time
print('ready', flush=True)
end = time.monotonic() + 0.5
while time.monotonic() < end: pass
time.sleep(600)
"""
STARTING = """
import subprocess, sys
print('ready', flush=True)
sys.stdin.readline()
subprocess.run([sys.executable, '-c', 'print("busy", flush=True)\\nwhile True: pass'])
"""
TURNING_BUSY = """
import sys
print('ready', flush=True)
sys.stdin.readline()
print('busy', flush=True)
while True: pass
"""
BUSY = "print('ready', flush=True)\nwhile True: pass"


class FakeWorld:
    """Notes what the proxy driver does; the driver sends commands as scripted: before rest, and after."""

    def __init__(self, before=1, after=0, listens=True):
        self.done = []
        self.helper = 0
        self.looks = [set()]  # at the connections that are missing; the last one stays
        self.states = ["steady"]  # of the connections, as long; the last one stays
        self.listens = listens
        self.is_up = True
        self.is_heard = True
        self._count, self._before, self._after = 0, before, after
        self._asked = 0

    def helpers(self):
        return [self.helper] if self.helper else []

    def connections(self):
        return self.states.pop(0) if self.states[1:] else self.states[0]

    def connecting(self):
        return 0.001

    def missing(self):
        return self.looks.pop(0) if self.looks[1:] else self.looks[0]

    def commands(self):
        self._asked += 1
        self._count += self._before if self._asked % 2 else self._after
        return self._count

    def has_node(self):
        return self.is_up

    def has_listener(self):
        return self.listens

    def publish_scans(self):
        self.done.append("scan")
        return self.is_heard

    def publish_clock(self, stamp):
        self.done.append(stamp)
        return self.is_heard

    def is_over(self):
        return False


@pytest.fixture
def driver(monkeypatch):
    """Starts a process that plays the driver; everything in the proxy driver goes a little faster."""
    for name in ("_PACE", "_CONNECTION_INTERVAL"):
        monkeypatch.setattr(proxy_driver, name, 0.001)
    running = []

    def start(program=IDLE):
        name, _, value = MARK.partition("=")
        process = subprocess.Popen(
            [sys.executable, "-c", program],
            env={name: value},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        running.append(process)
        process.stdout.readline()
        return process

    yield start
    for process in running:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()


def make_busy(process):
    """Let a driver that waits for a line go on; returns when it, or what it has started, spins."""
    process.stdin.write("start\n")
    process.stdin.flush()
    assert process.stdout.readline() == "busy\n"


@pytest.fixture
def hurried(monkeypatch):
    """The proxy driver gives a driver less time to load."""
    monkeypatch.setattr(proxy_driver, "_LOADING", 0.2)
    monkeypatch.setattr(proxy_driver, "_SPINNING", 0.1)


def test_scan_comes_before_the_time(driver):
    driver()
    world = FakeWorld()
    ProxyDriver(world, MARK, PATIENCE, PATIENCE).act("now")
    assert world.done == ["scan", "now"]


def test_nothing_comes_before_all_have_loaded_and_connected(driver, hurried):
    driver(LOADING)
    world = FakeWorld(before=0, listens=False)
    world.states = ["none", "one", "two"]
    one_is_missing = {("topic", "publisher", "subscriber")}
    world.looks = [one_is_missing, one_is_missing, set()]
    began = time.monotonic()
    ProxyDriver(world, MARK, PATIENCE, 30.0).begin()
    assert time.monotonic() - began > proxy_driver._LOADING
    assert (world.done, world.states, world.looks) == ([], ["two"], [set()])


def test_who_listens_late_is_not_taken_to_spin(driver, hurried):
    driver(LOADING)
    world = FakeWorld(before=0, listens=False)
    world.states = ["none", "one"]
    listens_late = threading.Timer(0.35, setattr, (world, "listens", True))
    listens_late.start()
    ProxyDriver(world, MARK, PATIENCE, 30.0).begin()
    listens_late.join()
    assert world.states == ["one"]  # it has been waited for


def test_connection_that_never_comes_about_is_waited_for_once(driver, monkeypatch):
    monkeypatch.setattr(proxy_driver, "_UNCONNECTED", 0.2)
    driver()
    world = FakeWorld()
    world.looks = [{("topic", "publisher", "subscriber")}]
    one = ProxyDriver(world, MARK, PATIENCE, 30.0)
    one.begin()
    world.states = ["other"]
    began = time.monotonic()
    one.act(0)
    assert time.monotonic() - began < proxy_driver._UNCONNECTED


def test_who_waits_for_the_master_is_not_at_rest(driver, hurried):
    driver()
    world = FakeWorld(before=0)
    world.helper = driver(LOADING).pid
    began = time.monotonic()
    ProxyDriver(world, MARK, PATIENCE, 30.0).begin()
    assert time.monotonic() - began > proxy_driver._LOADING


def test_who_waits_for_a_process_just_started_is_not_at_rest(driver, hurried, monkeypatch):
    monkeypatch.setattr(proxy_driver, "_SEARCH_INTERVAL", 1e6)
    process = driver(STARTING)
    world = FakeWorld(before=0, listens=False)
    one = ProxyDriver(world, MARK, PATIENCE, PATIENCE)
    one.begin()
    make_busy(process)
    with pytest.raises(MismatchError, match="do not come to rest"):
        one.act(0)


def test_who_spins_is_not_given_more_time_for_it_twice(driver, hurried):
    driver(BUSY)
    world = FakeWorld(before=0)
    one = ProxyDriver(world, MARK, PATIENCE, PATIENCE)
    began = one._time()
    one.begin()
    with pytest.raises(MismatchError):
        one.act(0)
    assert one._time() - began < PATIENCE + proxy_driver._LOADING
    assert world.done == ["scan"]


def test_driver_that_fits_has_started_up_after_some_periods(driver):
    driver()
    world = FakeWorld()
    one = ProxyDriver(world, MARK, PATIENCE, PATIENCE)
    for period in range(40):
        one.act(period)
    assert world.done[-2:] == ["scan", 39]


@pytest.mark.parametrize(
    ("has_sent", "is_heard", "waits"),
    [(True, True, 3), (True, False, 1), (False, True, 2), (False, False, 0)],
)
def test_who_was_given_nothing_is_at_rest_still(driver, monkeypatch, has_sent, is_heard, waits):
    driver()
    world = FakeWorld()
    one = ProxyDriver(world, MARK, PATIENCE, PATIENCE)
    for period in range(proxy_driver._STEADY_PERIODS + 1):
        one.act(period)
    waited = []
    monkeypatch.setattr(one._rest, "renew", lambda: waited.append("for rest"))
    world.is_heard = is_heard
    one.act("later", has_sent)
    assert len(waited) == waits


def test_who_starts_up_is_waited_for_though_it_seems_to_be_given_nothing(driver, monkeypatch):
    driver()
    world = FakeWorld()
    world.is_heard = False
    one = ProxyDriver(world, MARK, PATIENCE, PATIENCE)
    waited = []
    monkeypatch.setattr(one._rest, "renew", lambda: waited.append("for rest"))
    one.act("now", has_sent=False)
    assert len(waited) >= 3


def calm_proxy_driver(world):
    """One whose driver has neither connected nor sent a command for a while, and how long it sleeps."""
    slept, gone = [], []

    def sleep(seconds):
        slept.append(seconds)
        gone.append(seconds)

    one = ProxyDriver(world, MARK, PATIENCE, 1e6, lambda: time.monotonic() + sum(gone), sleep)
    one.act(0)  # in which the connections are new
    for period in range(proxy_driver._CALM_PERIODS):
        one.act(period)
    slept.clear()
    return one, slept


def is_watched(slept):
    """Whether a driver was looked at for a whole pace."""
    return proxy_driver._PACE in slept


def test_who_does_nothing_for_long_is_looked_at_less_closely(driver, monkeypatch):
    monkeypatch.setattr(proxy_driver, "_PACE", 60.0)
    driver()
    one, slept = calm_proxy_driver(FakeWorld(before=0))
    one.act("now")
    assert not is_watched(slept)
    assert max(slept) == pytest.approx(proxy_driver._PACE, abs=10.0)  # time goes on no faster than in reality


def test_who_has_not_come_up_is_looked_at_closely(driver, monkeypatch):
    monkeypatch.setattr(proxy_driver, "_PACE", 60.0)
    driver()
    world = FakeWorld(before=0)
    world.is_up = False
    one, slept = calm_proxy_driver(world)
    one.act("now")
    assert is_watched(slept)


@pytest.mark.parametrize("what", ["connection", "command"])
def test_who_does_something_late_is_looked_at_closely_again(driver, monkeypatch, what):
    monkeypatch.setattr(proxy_driver, "_PACE", 60.0)
    driver()
    world = FakeWorld(before=0)
    one, slept = calm_proxy_driver(world)
    if what == "connection":
        world.states = ["another"]
    else:
        world._before = 1
    one.act("now")
    slept.clear()
    one.act("later")
    assert is_watched(slept)


def test_who_sends_commands_while_time_stands_still_does_not_fit(driver):
    driver()
    one = ProxyDriver(FakeWorld(before=0, after=1), MARK, PATIENCE, PATIENCE)
    one.act(0)
    one.act(1)
    with pytest.raises(MismatchError, match="by the wall clock, while simulated time stands still"):
        one.act(2)


def test_who_never_rests_does_not_fit_once_it_sends_commands(driver, hurried):
    driver(BUSY)
    with pytest.raises(MismatchError, match="but its threads do not come to rest within 0.2 s; sleep by"):
        ProxyDriver(FakeWorld(), MARK, PATIENCE, PATIENCE).act("now")


class UnheardWorld(FakeWorld):
    """Nobody hears the driver's commands before its connections have been asked for."""

    def connections(self):
        self.are_heard = True
        return super().connections()

    def commands(self):
        return super().commands() if hasattr(self, "are_heard") else 0


def test_who_never_rests_and_sends_before_its_first_period_does_not_fit(driver, hurried):
    driver(BUSY)
    began = time.monotonic()
    with pytest.raises(
        MismatchError, match="it sends commands, but its threads do not come to rest within 0.2 s"
    ):
        ProxyDriver(UnheardWorld(listens=False), MARK, PATIENCE, 30.0).begin()
    assert time.monotonic() - began < 10.0


def test_who_sends_one_command_and_then_loads_is_waited_for(driver, hurried):
    driver(LOADING)
    world = UnheardWorld(before=0, listens=False)
    world._count = 1
    began = time.monotonic()
    ProxyDriver(world, MARK, PATIENCE, 30.0).begin()
    assert time.monotonic() - began > proxy_driver._LOADING + proxy_driver._SPINNING


def test_who_never_rests_gets_a_scan_but_no_time(driver, hurried):
    driver(BUSY)
    world = FakeWorld(before=0)
    with pytest.raises(
        MismatchError, match="do not come to rest within 1 s; sleep by simulated time in its "
    ):
        ProxyDriver(world, MARK, PATIENCE, PATIENCE).act("now")
    assert world.done == ["scan"]


def test_no_scan_is_lost_on_who_has_not_subscribed_yet(driver, hurried):
    driver(BUSY)
    world = FakeWorld(before=0, listens=False)
    with pytest.raises(MismatchError):
        ProxyDriver(world, MARK, PATIENCE, PATIENCE).act("now")
    assert world.done == []


def test_time_waits_for_who_loads_long(driver, hurried):
    driver(LOADING)
    world = FakeWorld(before=0, listens=False)
    began = time.monotonic()
    ProxyDriver(world, MARK, PATIENCE, 30.0).act("now")
    assert world.done == ["scan", "now"]
    assert time.monotonic() - began > proxy_driver._LOADING


def test_who_has_loaded_long_may_answer_just_before_it_rests(driver, hurried, monkeypatch):
    monkeypatch.setattr(proxy_driver, "_SPINNING", 5.0)
    driver(LOADING)
    ProxyDriver(FakeWorld(), MARK, PATIENCE, 30.0).act("now")


def test_who_drives_and_then_never_rests_is_given_up(driver):
    process = driver(TURNING_BUSY)
    one = ProxyDriver(FakeWorld(), MARK, PATIENCE, 30.0)
    for period in range(40):
        one.act(period)
    make_busy(process)
    with pytest.raises(NotAtRestError, match="the driver has not come to rest within 1 s"):
        one.act("later")


def test_time_stands_still_once_when_a_process_has_ended(driver):
    slept = []
    driver()
    victim = driver()
    one = ProxyDriver(FakeWorld(), MARK, PATIENCE, PATIENCE, sleep=slept.append)
    one.act(0)
    victim.kill()
    victim.wait()
    for period in range(1, 4):
        one.act(period)
    assert slept.count(proxy_driver._NOTICING) == 1
