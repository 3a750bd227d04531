"""The exceptions of this package."""

import contextlib
import os
import re
from collections.abc import Iterator
from pathlib import Path


class ScenarioError(Exception):
    """What the user asked for cannot be done; the message is one line: where, what, what is allowed."""


class NotApplicableError(ScenarioError):
    """A scenario does not apply to the planner that it is to be run with; the message says why."""


class FileError(Exception):
    """A file is not as it must be; one line: FILE:LINE or FILE, place, what was found, what is allowed."""


class CircuitError(FileError):
    """A circuit that cannot be built; one line: its name, place, what was found, what is allowed."""


class MapError(FileError):
    """A file is not a map; the text is one line that names it."""


class MismatchError(Exception):
    """A car's driver turned out not to fit lockstep; the message says which and why."""


class NotAtRestError(Exception):
    """A driver that has started up does not come to rest any more."""


def as_typed(text: str) -> str:
    """What is said of options, for whoever typed `make race`: INTERFACE=f1tenth, not --interface f1tenth.

    The Makefile says by F1TENTH_TYPED that this is the case.
    """
    if os.environ.get("F1TENTH_TYPED") != "make":
        return text
    return re.sub(
        r"--(planner|interface|laps)\b( (?!is )(?=\S))?",
        lambda found: found[1].upper() + ("=" if found[2] else ""),
        text,
    )


@contextlib.contextmanager
def as_scenario_error(*kinds: type[Exception]) -> Iterator[None]:
    """Raise another package's error about a user's mistake as a ScenarioError."""
    try:
        yield
    except kinds as error:
        raise ScenarioError(str(error)) from error


@contextlib.contextmanager
def writing(path: Path) -> Iterator[None]:
    """Raise a ScenarioError if a file that the user has named cannot be written."""
    try:
        yield
    except OSError as error:
        raise ScenarioError(f"{path}: cannot be written: {error.strerror}") from error
