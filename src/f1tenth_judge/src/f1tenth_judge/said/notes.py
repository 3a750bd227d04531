"""What a planner that is a class notes, as it is sent to the judge."""

import functools
import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from f1tenth_judge.record.replay import Drawing
from f1tenth_judge.said.said import Said

MOST = 1 << 20  # bytes, of the notes of a period
_POINTS, _RADIUS = 100, 0.05  # of a line, at most; m, of a point
_ALLOWED = "must be a number, a point (x, y), or points"


def text_of(notes: Mapping[str, Any]) -> bytes:
    """What is sent.

    Raises:
        TypeError: a note is something else than numbers, or all are too many.
    """
    try:
        text = json.dumps({str(name): _array(value).tolist() for name, value in notes.items()}).encode()
    except (TypeError, ValueError, AttributeError) as error:
        raise TypeError(f"notes are {notes!r}, each {_ALLOWED}") from error
    if len(text) > MOST:
        raise TypeError(f"notes of a period have {len(text)} bytes, may have {MOST}")
    return text


def keep(said: Said, car: str, now: float, text: bytes) -> None:
    """Keep what a car's planner has sent at a time (s), as far as it is made of notes."""
    try:
        notes = {name: _array(value) for name, value in json.loads(text).items()}
    except (TypeError, ValueError, AttributeError, OverflowError, RecursionError):
        return
    for name, values in notes.items():
        topic = f"/{car}/{name}"
        if values.ndim == 0:
            said.number(topic, now, float(values), car)
        else:
            said.draw(topic, now, functools.partial(_shown, name, values.reshape(-1, 2)))


def _array(value: Any) -> np.ndarray:
    """() of a number, (2,) of a point, (n, 2) of points."""
    values = np.asarray(value, dtype=float)
    if values.size and values.shape not in ((), (2,)) and values.shape[1:] != (2,):
        raise ValueError(f"numbers of shape {values.shape}, {_ALLOWED}")
    return values


def _shown(name: str, points: np.ndarray, _now: float) -> list[Drawing]:
    """A point or a line, with its name at the end."""
    there = points[np.isfinite(points).all(axis=1)].round(3)
    there = there[:: -(-len(there) // _POINTS) or 1].tolist()
    if not there:
        return []
    dots, lines = ([(*there[0], _RADIUS)], []) if len(there) == 1 else ([], [there])
    return [Drawing(lines=lines, dots=dots, texts=[(*there[-1], name)])]
