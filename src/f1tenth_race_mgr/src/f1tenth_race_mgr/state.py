"""The states of a race."""

from enum import IntEnum

from f1tenth_race_mgr.msg import RaceStatus


class State(IntEnum):
    """The constants of RaceStatus."""

    WAITING = RaceStatus.WAITING
    RACING = RaceStatus.RACING
    FINISHED = RaceStatus.FINISHED
    ABORTED = RaceStatus.ABORTED
    STOPPED = RaceStatus.STOPPED
    LOST = RaceStatus.LOST
