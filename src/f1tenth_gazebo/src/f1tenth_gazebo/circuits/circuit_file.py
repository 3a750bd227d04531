"""Reads a circuit from its YAML file."""

import math
from pathlib import Path

import yaml

from f1tenth_gazebo.circuits.circuit import (
    MAX_WIDTH,
    MIN_RADIUS,
    MIN_WIDTH,
    OPENING_HEIGHTS,
    Circuit,
    Corner,
    Opening,
    Prop,
    Room,
)
from f1tenth_gazebo.errors import CircuitError

_KEYS = {"corners", "left_material", "right_material", "openings", "rooms", "props"}


def load_circuit(path):
    """Read a circuit's YAML file.

    Raises:
        CircuitError: if the file cannot be read or describes no circuit that can be driven.
    """
    path = Path(path)
    try:
        document = yaml.safe_load(path.read_text())
    except (OSError, yaml.YAMLError) as error:
        raise CircuitError(f"{path}: {' '.join(str(error).split())}") from error
    return _Reader(path).circuit(document)


class _Reader:
    """Turns the YAML document into a Circuit and names the place of each mistake."""

    def __init__(self, path):
        self._path = path

    def circuit(self, document):
        self._mapping(document, "the file", {"corners"}, _KEYS - {"corners"})
        corners = tuple(
            self._corner(c, f"corners[{i}]") for i, c in enumerate(self._list(document, "corners"))
        )
        self._check_start(corners)
        materials = {
            key: self._text(document[key], key)
            for key in ("left_material", "right_material")
            if key in document
        }
        return Circuit(
            name=self._path.stem,
            corners=corners,
            openings=tuple(
                self._opening(o, f"openings[{i}]") for i, o in enumerate(self._list(document, "openings"))
            ),
            rooms=tuple(self._room(r, f"rooms[{i}]") for i, r in enumerate(self._list(document, "rooms"))),
            props=tuple(self._prop(p, f"props[{i}]") for i, p in enumerate(self._list(document, "props"))),
            **materials,
        )

    def _corner(self, entry, place):
        self._mapping(entry, place, {"at", "width", "radius"})
        x, y = self._numbers(entry["at"], f"{place}.at", 2)
        (width,) = self._numbers([entry["width"]], f"{place}.width", 1)
        (radius,) = self._numbers([entry["radius"]], f"{place}.radius", 1)
        if not MIN_WIDTH <= width <= MAX_WIDTH:
            self._fail(f"{place}.width", f"found {width}, allowed: {MIN_WIDTH} to {MAX_WIDTH} m")
        if radius < MIN_RADIUS:
            self._fail(f"{place}.radius", f"found {radius}, allowed: at least {MIN_RADIUS} m")
        return Corner(x, y, width, radius)

    def _check_start(self, corners):
        if len(corners) < 3:
            self._fail("corners", f"found {len(corners)}, allowed: at least 3")
        first, last = corners[0], corners[-1]
        if not (first.y == last.y == 0 and last.x < 0 < first.x):
            self._fail(
                "corners", "the way from the last to the first must lead through the origin in direction +x"
            )

    def _opening(self, entry, place):
        self._mapping(entry, place, {"kind", "near", "width"})
        if self._text(entry["kind"], f"{place}.kind") not in OPENING_HEIGHTS:
            self._fail(f"{place}.kind", f"found {entry['kind']!r}, allowed: {', '.join(OPENING_HEIGHTS)}")
        x, y = self._numbers(entry["near"], f"{place}.near", 2)
        (width,) = self._numbers([entry["width"]], f"{place}.width", 1)
        return Opening(entry["kind"], x, y, width)

    def _room(self, entry, place):
        self._mapping(entry, place, {"points"}, {"material"})
        points = self._list(entry, "points", f"{place}.")
        if len(points) < 2:
            self._fail(f"{place}.points", f"found {len(points)}, allowed: at least 2")
        return Room(
            tuple(tuple(self._numbers(p, f"{place}.points[{i}]", 2)) for i, p in enumerate(points)),
            self._text(entry.get("material", "Gazebo/Grey"), f"{place}.material"),
        )

    def _prop(self, entry, place):
        self._mapping(entry, place, {"model", "at"})
        return Prop(
            self._text(entry["model"], f"{place}.model"), *self._numbers(entry["at"], f"{place}.at", 3)
        )

    def _mapping(self, entry, place, required, optional=frozenset()):
        if not isinstance(entry, dict):
            self._fail(place, f"found {entry!r}, allowed: a mapping")
        for key in sorted(required - entry.keys()):
            self._fail(place, f"{key} is missing")
        for key in sorted(entry.keys() - required - optional, key=str):
            self._fail(place, f"unknown key {key!r}, allowed: {', '.join(sorted(required | optional))}")

    def _text(self, value, place):
        if not isinstance(value, str):
            self._fail(place, f"found {value!r}, allowed: a text")
        return value

    def _list(self, document, key, place=""):
        entries = document.get(key, [])
        if not isinstance(entries, list):
            self._fail(f"{place}{key}", f"found {entries!r}, allowed: a list")
        return entries

    def _numbers(self, values, place, count):
        if not isinstance(values, list) or len(values) != count:
            self._fail(place, f"found {values!r}, allowed: a list of {count} numbers")
        for value in values:
            if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
                self._fail(place, f"found {value!r}, allowed: a number")
        return [float(value) for value in values]

    def _fail(self, place, reason):
        raise CircuitError(f"{self._path}: {place}: {reason}")
