"""The centreline of a circuit as a file of the F1TENTH community."""

from f1tenth_gazebo.circuits.centreline import centreline

HEADER = "# x_m, y_m, w_tr_right_m, w_tr_left_m"


def centreline_text(circuit):
    """One lap in the format of f1tenth_racetracks, from the start line on."""
    vertices = centreline(circuit)
    points = [(0.0, 0.0, _width_at_start(circuit)), *((v.x, v.y, v.width) for v in vertices)]
    rows = [f"{x:.4f}, {y:.4f}, {width / 2:.4f}, {width / 2:.4f}" for x, y, width in points]
    return "\n".join([HEADER, *rows]).replace("-0.0000", "0.0000") + "\n"


def _width_at_start(circuit):
    first, last = circuit.corners[0], circuit.corners[-1]
    return last.width + (first.width - last.width) * -last.at.x / (first.at.x - last.at.x)
