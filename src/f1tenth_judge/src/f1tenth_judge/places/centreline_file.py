"""The centreline of a circuit as a file of the F1TENTH community."""

import numpy as np

from f1tenth_judge.places.centreline import centreline

_SPACING = 0.3  # m, at most between two rows: planners that look for the nearest row find it near
_HEADER = "# x_m, y_m, w_tr_right_m, w_tr_left_m"


def centreline_beside(world):
    """Where the centreline of a world or a map is: X_centerline.csv beside X.world, X.yaml or X_map.yaml."""
    return world.with_name(f"{world.stem.removesuffix('_map')}_centerline.csv")


def table_text(rows):
    """Rows of x, y and the widths to the right and to the left, m, in the format of f1tenth_racetracks."""
    lines = [_HEADER, *(", ".join(f"{value:.4f}" for value in row) for row in rows)]
    return "\n".join(lines).replace("-0.0000", "0.0000") + "\n"


def centreline_text(circuit):
    """One lap in the format of f1tenth_racetracks, from the start line on."""
    vertices = centreline(circuit)
    points = np.array([(0.0, 0.0, _width_at_start(circuit)), *((v.x, v.y, v.width) for v in vertices)])
    return table_text((x, y, width / 2, width / 2) for x, y, width in _dense(points))


def _dense(points):
    """A closed line with further points on its straight pieces."""
    for start, end in zip(points, np.roll(points, -1, axis=0)):
        count = int(np.ceil(np.hypot(*(end - start)[:2]) / _SPACING))
        yield from start + np.linspace(0.0, 1.0, count, endpoint=False)[:, np.newaxis] * (end - start)


def _width_at_start(circuit):
    first, last = circuit.corners[0], circuit.corners[-1]
    return last.width + (first.width - last.width) * -last.at.x / (first.at.x - last.at.x)
