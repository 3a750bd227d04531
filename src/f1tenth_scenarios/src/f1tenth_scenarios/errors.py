"""The exceptions of this package."""

import contextlib
from collections.abc import Iterator
from pathlib import Path


class ScenarioError(Exception):
    """What the user asked for cannot be done; the message is one line: where, what, what is allowed."""


class NotApplicableError(ScenarioError):
    """A scenario says nothing about the planner that it is to be run with; the message says why."""


class MisfitError(Exception):
    """A car's driver turned out not to fit lockstep; the message says which and why."""


class RestlessError(Exception):
    """A driver that has started up does not come to rest any more."""


@contextlib.contextmanager
def as_scenario_error(*kinds: type[Exception]) -> Iterator[None]:
    """Raise what another package says of a user's mistake as a ScenarioError."""
    try:
        yield
    except kinds as error:
        raise ScenarioError(str(error)) from error


@contextlib.contextmanager
def writing(path: Path) -> Iterator[None]:
    """Raise that a file cannot be written, which the user has named, as a ScenarioError."""
    try:
        yield
    except OSError as error:
        raise ScenarioError(f"{path}: cannot be written: {error.strerror}") from error
