"""Where worlds, cars and data are."""

import os
from pathlib import Path

from .benchmark import NotAvailable

REPOSITORY = Path(__file__).resolve().parents[4]


def circuit_file(name):
    """Path of a circuit that the workspace ships."""
    return REPOSITORY / "src" / "f1tenth_gazebo" / "worlds" / f"{name}.world"


def data_file(relative):
    """Path of a file among the data made by others.

    Raises:
        NotAvailable: it is not there.
    """
    data = Path(os.environ.get("F1TENTH_DATA", REPOSITORY.parent / "shared" / "data"))
    path = data / relative
    if not path.exists():
        raise NotAvailable(f"no {path}; F1TENTH_DATA says where the data are")
    return path
