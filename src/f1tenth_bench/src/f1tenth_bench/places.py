"""Where worlds, descriptions and data are."""

import os
from pathlib import Path

from f1tenth_judge.places.lookup import GAZEBO_PACKAGE, package_path

from f1tenth_bench.benchmark import NotAvailable


def circuit_file(name):
    """Path of the world of a circuit that the workspace ships."""
    return package_path(GAZEBO_PACKAGE) / "worlds" / f"{name}.world"


def data_file(relative):
    """Path of a file among the data made by others.

    Raises:
        NotAvailable: it is not there.
    """
    data = Path(os.environ.get("F1TENTH_DATA", package_path("f1tenth_bench") / "../../../shared/data"))
    path = data / relative
    if not path.exists():
        raise NotAvailable(f"no {path}; F1TENTH_DATA says where the data are")
    return path


def executable(name, package="f1tenth_sim2d"):
    """Path of an executable in the devel or install space.

    Raises:
        NotAvailable: it has not been built.
    """
    for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(":"):
        path = os.path.join(prefix, "lib", package, name)
        if os.access(path, os.X_OK):
            return path
    raise NotAvailable(f"no executable {package}/{name}: build the workspace and source its setup.bash")
