"""Which versions a result was made with."""

import functools
import platform
import subprocess
from typing import Optional

import rospkg

from f1tenth_scenarios import places

_PACKAGES = (
    "f1tenth_scenarios",
    "f1tenth_sim2d",
    "f1tenth_gazebo",
    "f1tenth_description",
    "f1tenth_race_mgr",
    "move_base",
)


def collect() -> dict[str, Optional[str]]:
    """The commit of the workspace (nothing outside of git) and the versions of the packages."""
    versions = {"commit": commit(), "python": platform.python_version()}
    versions.update((package, _package_version(package)) for package in _PACKAGES)
    return versions


@functools.lru_cache
def commit() -> Optional[str]:
    """The commit of the workspace, with `-dirty` if it was changed since; nothing outside of git."""
    folder = places.package_path(places.PACKAGE)
    command = ["git", "-C", str(folder), "describe", "--always", "--dirty", "--abbrev=12"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=10)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout.strip() if done.returncode == 0 else None


def _package_version(package: str) -> Optional[str]:
    try:
        return places.packages().get_manifest(package).version
    except rospkg.ResourceNotFound:
        return None
