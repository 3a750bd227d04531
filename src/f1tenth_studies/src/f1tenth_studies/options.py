"""Numbers that commands are given: what is wrong with them is one line."""

from typing import Optional

from f1tenth_scenarios.errors import ScenarioError


def expect_at_least(least: int, number: Optional[int], option: str) -> None:
    """Tell a number that makes no sense before the work.

    Raises:
        ScenarioError: the number that an option was given is less.
    """
    if number is not None and number < least:
        raise ScenarioError(f"{option} is {number}, must be at least {least}")
