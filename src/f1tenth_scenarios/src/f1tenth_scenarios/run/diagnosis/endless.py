"""A driver that computes without end."""

import time
from collections.abc import Mapping

from f1tenth_judge.drivers.rest import ProcessorUse, Thread, marked_processes, processor_use

Uses = Mapping[Thread, ProcessorUse]

_LOOK = 2.0  # wall s; what a thread waits is noted when it gets a processor, a moment later on a busy machine
_WITHOUT_PAUSE = 0.75  # part of the time


def computes_without_pause(mark: str) -> bool:
    """Whether a thread wants a processor all the time, of processes with NAME=VALUE in their environment."""
    pids = marked_processes(mark)
    before, began = processor_use(pids), time.monotonic()
    time.sleep(_LOOK)
    return wanted_by_one(before, processor_use(pids)) > _WITHOUT_PAUSE * (time.monotonic() - began)


def wanted_by_one(before: Uses, after: Uses) -> float:
    """For how long a thread wanted a processor between two looks, s: the one that did so most."""
    common = after.keys() & before.keys()
    return max((sum(after[each][1:3]) - sum(before[each][1:3]) for each in common), default=0.0)
