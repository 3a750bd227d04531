"""What a car is to do, so that the simulator's record alone can say whether it did."""

import dataclasses
from typing import Optional

from f1tenth_judge.scenario.car import Pose
from f1tenth_judge.scenario.scenario import StartLine


@dataclasses.dataclass(frozen=True)
class Task:
    """Goals to be passed in order, or laps over a line; a car with neither only takes part."""

    goals: tuple[Pose, ...] = ()  # of all laps
    laps: int = 0
    line: Optional[StartLine] = None  # of the laps
    gates: tuple[StartLine, ...] = ()  # that each lap leads through, in order; none where no road is known
    obeys_start: bool = False  # whether moving before the countdown is over is a false start
    reports: bool = False  # whether its driver says itself when it has reached its goals

    @property
    def is_empty(self) -> bool:
        """Whether there is nothing to do."""
        return not self.goals and not self.laps
