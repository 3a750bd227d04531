"""What is to happen at which simulated time, and when a control period may go on."""

from collections.abc import Iterable
from typing import Callable

from f1tenth_judge.record.record import STAMP_EPSILON

Action = Callable[[], None]


class Agenda:
    """Actions in order of time."""

    def __init__(self, entries: Iterable[tuple[float, Action]]):
        """`entries`: simulated time (s) and what is done then."""
        self._entries = sorted(entries, key=lambda entry: entry[0])

    @property
    def empty(self) -> bool:
        """Whether nothing is left to do."""
        return not self._entries

    def is_due(self, now: float) -> bool:
        """Whether something is to be done at this time (s) or before."""
        return bool(self._entries) and self._entries[0][0] <= now + STAMP_EPSILON

    def act(self, now: float) -> None:
        """Do all that is due."""
        while self.is_due(now):
            _, action = self._entries.pop(0)
            action()


class PeriodGate:
    """Which participants have answered which control period.

    In lockstep an action waits for those it concerns, so that it always falls between the same two messages.
    """

    def __init__(self, names: Iterable[str]):
        self._answered = dict.fromkeys(names, -1.0)

    def answer(self, name: str, stamp: float) -> None:
        """A participant has acted up to a stamp (s)."""
        if name in self._answered:
            self._answered[name] = max(self._answered[name], stamp)

    def is_open(self, stamp: float) -> bool:
        """Whether all have acted up to a stamp (s)."""
        return all(answered + STAMP_EPSILON >= stamp for answered in self._answered.values())
