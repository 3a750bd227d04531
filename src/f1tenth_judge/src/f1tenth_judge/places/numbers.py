"""Tables of numbers, as the F1TENTH community keeps its lines: one row per point, `#` before a remark."""

import math
from pathlib import Path

import numpy as np

from f1tenth_judge.errors import ScenarioError

_LEAST_ROWS = 3  # of a closed line
_WORDS = {4: "four", 7: "seven"}


def read_lines(path: Path) -> list[tuple[str, str]]:
    """The lines that say something, without remarks, each after its place: FILE:LINE.

    Raises:
        ScenarioError: the file cannot be read.
    """
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise ScenarioError(f"{path}: cannot be read: {error}") from error
    texts = ((f"{path}:{number}", line.split("#")[0].strip()) for number, line in enumerate(lines, start=1))
    return [(place, text) for place, text in texts if text]


def read_number(place: str, name: str, text: str) -> float:
    """Read a number that stands at a place, FILE:LINE, and is called so.

    Raises:
        ScenarioError: it is none, or not finite.
    """
    try:
        value = float(text)
    except ValueError as error:
        raise ScenarioError(f'{place}: {name} is not a number: "{text}"') from error
    if not math.isfinite(value):
        raise ScenarioError(f"{place}: {name} is not finite: {text}")
    return value


def read_numbers(path: Path, separator: str, columns: str) -> np.ndarray:
    """Read a table of shape (points, columns); `columns` are their names, with the separator between them.

    Raises:
        ScenarioError: with the file, the line and what is wrong there.
    """
    rows = [_row(place, text, separator, columns) for place, text in read_lines(path)]
    if len(rows) < _LEAST_ROWS:
        raise ScenarioError(f"{path}: {len(rows)} points, must be at least {_LEAST_ROWS}: {columns}")
    return np.array(rows)


def _row(place: str, text: str, separator: str, columns: str) -> list[float]:
    names, fields = columns.split(separator), text.split(separator)
    if len(fields) != len(names):
        raise ScenarioError(f"{place}: '{text}' must be {_WORDS[len(names)]} numbers: {columns}")
    return [read_number(place, name.strip(), field.strip()) for name, field in zip(names, fields)]
