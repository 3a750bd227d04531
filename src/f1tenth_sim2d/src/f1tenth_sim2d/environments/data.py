"""Where the circuits and the car's description are."""

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parents[1]
# Installed by pip; in the workspace; in an install space of catkin.
_ROOTS = (_PACKAGE / "data", _PACKAGE.parents[2], _PACKAGE.parents[3] / "share")


def data_path(relative):
    """Path of a file or folder of f1tenth_gazebo or f1tenth_description.

    Args:
        relative: path that begins with the name of the package.

    Raises:
        FileNotFoundError: it is in none of the possible places.
    """
    for root in _ROOTS:
        if (root / relative).exists():
            return root / relative
    raise FileNotFoundError(f"{relative}: not found in {', '.join(map(str, _ROOTS))}")
