"""Which versions a result was made with."""

import functools
import platform
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.places import lookup, packages

_PACKAGES = (
    "f1tenth_judge",
    "f1tenth_scenarios",
    "f1tenth_sim2d",
    "f1tenth_gazebo",
    "f1tenth_description",
    "f1tenth_race_mgr",
    "move_base",
)


def collect(drivers: Mapping[str, Path]) -> dict[str, Any]:
    """The commits, and the versions of the packages; `drivers` as of `commits`."""
    versions = {package: packages.package_version(package) for package in _PACKAGES}
    return {**commits(drivers), "python": platform.python_version(), **versions}


def commits(drivers: Mapping[str, Path]) -> dict[str, Any]:
    """The commit of the workspace, and per car that of its driver.

    Each with `-dirty` if the working copy was changed since; nothing outside of git.

    Args:
        drivers: per car, the folder of the driver's launch file
    """
    own = _commit(packages.package_path(lookup.PACKAGE))
    return {"commit": own, "driver_commits": {car: _commit(folder) for car, folder in drivers.items()}}


@functools.lru_cache  # as of the first call: the beginning of the run
def _commit(folder: Path) -> Optional[str]:
    command = ["git", "-C", str(folder), "describe", "--always", "--dirty", "--abbrev=12"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=10)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout.strip() if done.returncode == 0 else None
