"""What is seen of a run while it is in progress."""

import dataclasses
import enum
from typing import Optional

from f1tenth_judge.record.interventions import Intervention
from f1tenth_judge.record.record import Record


class RaceState(enum.IntEnum):
    """What a car's race_mgr says: the constants of f1tenth_race_mgr/RaceStatus."""

    WAITING = 0
    RACING = 1
    FINISHED = 2
    ABORTED = 3
    STOPPED = 4
    LOST = 5


@dataclasses.dataclass(frozen=True)
class RaceUpdate:
    """One message of a car's race_mgr."""

    car: str
    stamp: float  # s, simulated
    state: RaceState
    goals_reached: int
    reason: str = ""


@dataclasses.dataclass(frozen=True)
class Failure:
    """Why the set-up broke, and who broke it."""

    culprit: str  # a node's name, or "runner"
    reason: str
    log_file: Optional[str] = None
    log_lines: tuple[str, ...] = ()
    stamp: Optional[float] = None  # s, simulated, when it was clear; nothing: when the record ends


@dataclasses.dataclass(frozen=True)
class Observations:
    """All that a run is judged by."""

    record: Record
    updates: tuple[RaceUpdate, ...] = ()
    failure: Optional[Failure] = None
    interventions: tuple[Intervention, ...] = ()
    # s, of the last look before something broke: what the record shows later proves nothing.
    sound_until: Optional[float] = None
