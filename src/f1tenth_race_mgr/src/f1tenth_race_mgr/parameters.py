"""The parameters of the node."""

import os
from dataclasses import dataclass

BLOCK = "f1tenth_race_mgr"


@dataclass(frozen=True)
class Parameters:
    """What race_mgr reads."""

    use_absolute_fpath: bool = False
    package_name: str = "f1tenth_race_mgr"
    fpath: str = "/config/navigation_goals.txt"
    loop_mode: bool = False
    lockstep: bool = False
    wait_for_start: bool = True
    starter: str = ""  # the only node that may start the race; anybody, if empty
    exit_when_done: bool = False


def goals_path(parameters, find_package):
    """Return the path of the goals file; `find_package` maps the name of a package to its folder."""
    if parameters.use_absolute_fpath:
        return parameters.fpath
    return os.path.join(find_package(parameters.package_name), parameters.fpath.lstrip("/"))
