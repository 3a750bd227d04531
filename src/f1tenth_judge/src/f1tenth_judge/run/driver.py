"""Who drives a car in a run without ROS."""

from typing import Optional, Protocol

from f1tenth_judge.record.observations import Failure
from f1tenth_judge.run.stage import Stage


class Driver(Protocol):
    """Drives one car of a stage."""

    def begin(self) -> None:
        """Load, before the first period is acted on.

        Raises:
            MismatchError: it cannot go by simulated time.
        """

    def act(self, stage: Stage) -> None:
        """Handle a period that has passed, and command the car for the next one.

        Raises:
            MismatchError: it cannot go by simulated time.
        """

    def failure(self, time: float, is_done: bool) -> Optional[Failure]:
        """Why it is of no use at a simulated time (s); if its task `is_done`, it may end."""

    def note(self) -> str:
        """What whoever reads the result should know of it, in words; empty if nothing."""

    def close(self) -> None:
        """End all that it has started."""
