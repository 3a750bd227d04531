"""Where ROS finds packages."""

import functools
from collections.abc import Iterable
from pathlib import Path
from typing import Optional

import rospkg


class RosPackages:
    """All packages on ROS_PACKAGE_PATH."""

    def names(self) -> Iterable[str]:
        """Those that are installed."""
        return _packages().list()

    def path(self, package: str) -> Optional[Path]:
        """The folder of a package; None if it is not installed."""
        try:
            return Path(_packages().get_path(package))
        except rospkg.ResourceNotFound:
            return None


@functools.lru_cache(maxsize=1)
def _packages() -> rospkg.RosPack:
    # It walks through all of ROS_PACKAGE_PATH on the first call.
    return rospkg.RosPack()
