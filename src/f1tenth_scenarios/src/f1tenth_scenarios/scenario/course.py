"""The course of a race: a closed centreline and how far the road reaches on either side of it."""

import dataclasses
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from f1tenth_gazebo.circuits.centreline import centreline
from f1tenth_gazebo.circuits.circuit_file import load_circuit
from f1tenth_gazebo.errors import CircuitError

from f1tenth_scenarios.errors import ScenarioError


@dataclasses.dataclass(frozen=True)
class Course:
    """Arrays of shape (n,), one value a vertex; the last vertex is joined to the first."""

    x: np.ndarray  # m
    y: np.ndarray  # m
    right: np.ndarray  # m, from the centreline to the road's edge
    left: np.ndarray  # m

    def excess(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """How far points (m) lie beyond the nearest edge of the road, m; 0 on the road."""
        return np.array([self._excess(*point) for point in zip(x, y)])

    def _excess(self, x: float, y: float) -> float:
        ahead_x, ahead_y = np.roll(self.x, -1) - self.x, np.roll(self.y, -1) - self.y
        squares = np.maximum(ahead_x**2 + ahead_y**2, 1e-12)
        part = np.clip(((x - self.x) * ahead_x + (y - self.y) * ahead_y) / squares, 0.0, 1.0)
        off_x, off_y = x - self.x - part * ahead_x, y - self.y - part * ahead_y
        distance = np.hypot(off_x, off_y)
        is_left = ahead_x * off_y - ahead_y * off_x > 0
        width = np.where(is_left, self._between(self.left, part), self._between(self.right, part))
        return max(0.0, float((distance - width).min()))

    @staticmethod
    def _between(values, part):
        return values + part * (np.roll(values, -1) - values)


def read_course(path: Path) -> Course:
    """Read a circuit of f1tenth_gazebo (YAML) or a centreline of the F1TENTH community (X_centerline.csv).

    Raises:
        ScenarioError: with the file, the line and what is wrong there.
    """
    return _from_circuit(path) if path.suffix == ".yaml" else _from_table(path)


def _from_circuit(path):
    try:
        vertices = centreline(load_circuit(path))
    except CircuitError as error:
        raise ScenarioError(str(error)) from error
    x, y, width = np.array([(each.x, each.y, each.width) for each in vertices]).T
    return Course(x, y, width / 2, width / 2)


def _from_table(path):
    rows = []
    for number, line in enumerate(_lines(path), start=1):
        text = line.split("#")[0].strip()
        if text:
            rows.append(_numbers(path, number, text))
    if len(rows) < 3:
        raise ScenarioError(
            f"{path}: {len(rows)} points, must be at least 3: x_m, y_m, w_tr_right_m, w_tr_left_m"
        )
    return Course(*np.array(rows).T)


def _lines(path) -> Sequence[str]:
    try:
        return path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise ScenarioError(f"{path}: cannot be read: {error}") from error


def _numbers(path, number, text):
    try:
        values = [float(each) for each in text.split(",")]
    except ValueError as error:
        raise ScenarioError(f"{path}:{number}: {error}") from error
    if len(values) != 4 or not np.isfinite(values).all():
        raise ScenarioError(
            f"{path}:{number}: '{text}' must be four numbers: x_m, y_m, w_tr_right_m, w_tr_left_m"
        )
    return values
