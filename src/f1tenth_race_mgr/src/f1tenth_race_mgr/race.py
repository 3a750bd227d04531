"""The course of a race: pure logic, no ROS."""

from dataclasses import dataclass, replace

from f1tenth_navigation_mgr import GoalOutcome, SpinResult
from f1tenth_race_mgr.state import State


@dataclass(frozen=True)
class Status:
    """The status of the race."""

    state: State
    goals_reached: int
    goals_total: int
    text: str

    @property
    def laps(self):
        """How many times every goal of the file has been reached."""
        return self.goals_reached // self.goals_total


class Race:
    """Waits for the start, then drives from goal to goal until there is none left or something ends it.

    Args:
        navigation: a NavigationMgr with the goals loaded, or what looks like one: spin(now), cancel(),
            clear_goals(), goals_left and results.
        has_started: called without arguments, returns whether the race is on.
        publish: called with (Status, now) at the beginning and at every change.

    """

    def __init__(self, navigation, has_started, publish):
        self._navigation = navigation
        self._has_started = has_started
        self._publish = publish
        self._status = Status(State.WAITING, 0, navigation.goals_left, "waiting for the start signal")

    @property
    def status(self):
        """The status of the race."""
        return self._status

    @property
    def is_over(self):
        """Whether nothing can happen any more."""
        return self._status.state not in (State.WAITING, State.RACING)

    def announce(self, now):
        """Publish the status as it is."""
        self._publish(self._status, now)

    def step(self, now):
        """Do all there is to do at now (ROS time). Does not block."""
        if self._status.state is State.WAITING and self._has_started():
            self._change(now, State.RACING, "the race is on")
        if self._status.state is State.RACING:
            while self._drive(now):
                pass

    def stop(self, now):
        """End the race; the goal in flight is cancelled."""
        if self.is_over:
            return
        self._navigation.clear_goals()
        self._navigation.cancel()
        self._change(now, State.STOPPED, f"told to stop, {self._progress()}")

    def _drive(self, now):
        """Spin once; return whether another spin at the same time may do more."""
        did = self._navigation.spin(now)
        if did == SpinResult.REACHED:
            self._count_goal(now)
        elif did == SpinResult.FAILED:
            self._fail(now, self._navigation.results[-1])
        elif did in (SpinResult.QUEUE_EMPTY, SpinResult.IDLE):
            self._change(now, State.FINISHED, f"finished, {self._progress()}")
        return did in (SpinResult.REACHED, SpinResult.SENT)

    def _count_goal(self, now):
        self._status = replace(self._status, goals_reached=self._status.goals_reached + 1)
        self._change(now, State.RACING, self._progress())

    def _fail(self, now, result):
        state = State.LOST if result.outcome == GoalOutcome.LOST else State.ABORTED
        total = self._status.goals_total
        number = self._status.goals_reached % total + 1
        self._change(now, state, f"goal {number} of {total} {result.outcome.name.lower()}: {result.text}")

    def _progress(self):
        return f"{self._status.goals_reached} goals reached of {self._status.goals_total}"

    def _change(self, now, state, text):
        self._status = replace(self._status, state=state, text=text)
        self.announce(now)
