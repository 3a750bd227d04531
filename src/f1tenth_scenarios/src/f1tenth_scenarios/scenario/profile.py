"""A fixed command profile: what a car is told at which simulated time."""

from bisect import bisect_right
from collections.abc import Sequence

from f1tenth_scenarios.scenario.car import Command

STANDING = Command(at=0.0, speed=0.0)


def command_at(commands: Sequence[Command], now: float) -> Command:
    """The command that holds at a time (s): the last one begun; standing before the first."""
    begun = bisect_right([command.at for command in commands], now + 1e-9)
    return commands[begun - 1] if begun else STANDING
