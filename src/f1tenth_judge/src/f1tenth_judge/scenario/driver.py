"""Who drives a car: a launch file, a command or a class, and how it is to be started."""

import dataclasses
import enum
import re
from typing import Any

from f1tenth_judge.yaml_files.schema import Problem, key

_KINDS = {"launch": "launch file of ROS 1", "ros2": "command of ROS 2", "python": "Python class"}
REFERENCE = "race"  # the planner that drives where none is named
_OWN = "package://f1tenth_scenarios/launch/drivers"


class Interface(enum.Enum):
    """Which topics a planner knows."""

    NATIVE = "native"
    F1TENTH = "f1tenth"
    F1TENTH_GYM_ROS = "f1tenth_gym_ros"


# What a driver of each kind may name: the first one is what it has anyway.
_INTERFACES = {
    "launch": (Interface.NATIVE, Interface.F1TENTH),
    "ros2": (Interface.NATIVE, Interface.F1TENTH_GYM_ROS),
    "python": (Interface.NATIVE,),
}


@dataclasses.dataclass(frozen=True)
class Driver:
    """A driver as a scenario names it."""

    launch: str = key(
        "Launch file of ROS 1: a path relative to the scenario file, or package://PACKAGE/PATH. It is started"
        " in the car's namespace. One of this, `ros2` and `python` must be given.",
        default="",
    )
    interface: Interface = key(
        "`native`: the topics of the car's namespace; `f1tenth`: those of f1tenth_simulator and"
        " f1tenth_gym_ros (`/scan`, `/drive`, `/nav`, `/odom`, `/gt_pose`, `/ego_racecar/odom`,"
        " `/opp_scan`, …). `f1tenth_gym_ros`: what a command of ROS 2 finds, whether it is named or not.",
        default=Interface.NATIVE,
    )
    arguments: dict[str, str] = key(
        "Values for arguments of the launch file, NAME:=VALUE behind the command of `ros2`, or for `reset` of"
        " a class. One that names a file that is there, relative to the scenario file or as"
        " package://PACKAGE/PATH, is given as its path.",
        default={},
    )
    ros2: str = key(
        "Command that starts a planner of ROS 2, as in `ros2 launch my_package planner.launch.py`. It finds"
        " the topics of f1tenth_gym_ros.",
        default="",
    )

    python: str = key(
        "FILE.py:CLASS, a planner that is a Python class (f1tenth_judge.planner); the file is relative to the"
        " scenario file, or package://PACKAGE/PATH.",
        default="",
    )

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        given = [kind for kind in _KINDS if getattr(self, kind)]
        if len(given) != 1:
            found = f"is given beside '{given[1]}'" if given else "is missing"
            return (given or [*_KINDS])[0], f"{found}; exactly one of {', '.join(_KINDS)} is needed"
        if self.python and not re.fullmatch(r".+\.py:\w+", self.python):
            return "python", f"is '{self.python}', must be FILE.py:CLASS"
        if self.interface not in _INTERFACES[given[0]]:
            allowed = [each.value for each in _INTERFACES[given[0]][1:]] or ["none"]
            found = f"is '{self.interface.value}', may be {' or '.join(allowed)} for '{given[0]}'"
            return "interface", found
        return None

    @classmethod
    def short_forms(cls) -> dict[str, "Driver"]:
        """The drivers that we bring, by the names that stand for them."""
        return {
            REFERENCE: cls(f"{_OWN}/move_base.launch"),
            "pursuit": cls(f"{_OWN}/pure_pursuit.launch"),
            "commands": cls(f"{_OWN}/commands.launch"),
            "gap_follower": cls(f"{_OWN}/gap_follower.launch"),
        }

    def as_dict(self) -> dict[str, Any]:
        """As it is written in a scenario file."""
        launch = {"launch": self.launch, "interface": self.interface.value}
        others = {kind: getattr(self, kind) for kind in ("ros2", "python") if getattr(self, kind)}
        return (others or launch) | ({"arguments": dict(self.arguments)} if self.arguments else {})

    @property
    def is_ours(self) -> bool:
        """Whether it is one that we bring: it knows the topics of the F1/10 car, whatever it drives."""
        return self.launch.startswith(_OWN)

    @property
    def is_reference(self) -> bool:
        """Whether it is the planner that scenarios are written for."""
        return self.name == REFERENCE

    @property
    def name(self) -> str:
        """The short form, else the launch file, the command or the class."""
        names = (name for name, driver in self.short_forms().items() if driver.launch == self.launch)
        return self.ros2 or self.python or next(names, self.launch)

    @property
    def short_name(self) -> str:
        """The name without the folder of its file."""
        return self.ros2 or self.name.rpartition("/")[2]

    @property
    def kind(self) -> str:
        """What it is, in words."""
        return next(words for kind, words in _KINDS.items() if getattr(self, kind))
