"""A row of the simulator's record, however it is read: as a whole, or while it is written."""

import csv
import math
from collections.abc import Sequence
from typing import Any, NamedTuple


class Row(NamedTuple):
    """A car at the end of a control period."""

    time: float  # s
    car: str
    x: float  # m
    y: float  # m
    yaw: float  # rad
    v_x: float  # m/s, along the car
    v_y: float  # m/s, to the left of the car
    yaw_rate: float  # rad/s
    steering_angle: float  # rad
    clearance: float  # m
    contacts: str  # names joined by ";", empty without contact
    contact_speed: float  # m/s, see Contact
    hash: str


COLUMNS = Row._fields
_WORDS = ("car", "contacts", "hash")


def cells_of(line: str) -> list[str]:
    """The cells of a line; none if it is no line of such a file."""
    try:
        return next(csv.reader([line]), [])
    except csv.Error:
        return []


def row_of(cells: Sequence[str], is_partial: bool = False) -> Row:
    """A row from its cells; if it may be partial, empty numbers are NaN.

    Raises:
        ValueError: it is none.
    """
    if len(cells) != len(COLUMNS):
        raise ValueError(f"{len(cells)} values, must be {len(COLUMNS)}")
    values: list[Any] = [
        cell if name in _WORDS else _number(name, cell, cells, is_partial)
        for name, cell in zip(COLUMNS, cells)
    ]
    return Row(*values)


def _number(name: str, cell: str, cells: Sequence[str], is_partial: bool) -> float:
    if is_partial and not cell:
        return math.nan
    try:
        value = float(cell)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ValueError(f"{name} of {cells[1]} at {cells[0]} is {cell}, must be a finite number")
    return value
