"""Time that a driver could use: wall time without that for which its threads waited for a processor.

On a busy machine a planner needs longer for the same work, which is not its fault and must change nothing.
Nor is it when the judge itself was stopped, or had no processor, and did not see when the planner was ready.
"""

import dataclasses
from collections.abc import Callable, Iterable, Mapping
from typing import Optional

from f1tenth_judge.drivers.rest import ProcessorUse, Thread, processor_use

_LOOK_INTERVAL = 0.02  # wall s, between two looks at the threads: there may be many
_LONGEST = 1.0  # wall s, that count between two calls


class GrantedTime:
    """Time for the threads of some processes, s; it never goes back, and never faster than wall time."""

    def __init__(
        self,
        clock: Callable[[], float],
        look: Callable[[Iterable[int]], Mapping[Thread, ProcessorUse]] = processor_use,
    ):
        """`clock`: wall time (s); `look`: what the threads of processes have had of the processors so far."""
        self._clock = clock
        self._look = look
        self._looked = clock()
        self._seen: dict[Thread, _Seen] = {}
        self._lost = 0.0
        self._now = self._looked

    def now(self, pids: Iterable[int]) -> float:
        """The time for these processes."""
        wall = self._clock()
        if wall - self._looked >= _LOOK_INTERVAL:
            lost = self._lost_since(self._looked, wall, pids)
            self._lost += max(lost, wall - self._looked - _LONGEST)
            self._looked = wall
        self._now = max(self._now, wall - self._lost)
        return self._now

    def _lost_since(self, looked: float, wall: float, pids: Iterable[int]) -> float:
        """Of the time for which they wanted a processor, the part in which they had to wait for one."""
        before = self._seen
        self._seen = {
            thread: _Seen.of(use, before.get(thread), wall) for thread, use in self._look(pids).items()
        }
        known = [(before[thread], now) for thread, now in self._seen.items() if thread in before]
        waited = sum(max(0.0, now.waited - old.waited) for old, now in known)
        wanted = waited + sum(now.use.ran - old.use.ran for old, now in known)
        return min(wall - looked, wanted) * waited / wanted if waited else 0.0


@dataclasses.dataclass(frozen=True)
class _Seen:
    """What was seen of a thread."""

    use: ProcessorUse
    since: float  # wall s, since when it is like that
    waited: float  # s, for a processor

    @staticmethod
    def of(use: ProcessorUse, before: Optional["_Seen"], wall: float) -> "_Seen":
        """The kernel counts a wait when it is over: what wants to run, and has not since, waits."""
        since = before.since if before and before.use == use else wall
        return _Seen(use, since, use.waited + (wall - since if use.is_ready else 0.0))
