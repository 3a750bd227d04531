"""Who drives a car: a launch file, and how it is to be started."""

import dataclasses
import enum
from typing import Any

from f1tenth_judge.yaml_files.schema import Problem, key

_OWN = "package://f1tenth_scenarios/launch/drivers"


class Interface(enum.Enum):
    """Which topics a planner knows."""

    NATIVE = "native"
    F1TENTH = "f1tenth"


@dataclasses.dataclass(frozen=True)
class Driver:
    """A driver as a scenario names it."""

    launch: str = key(
        "Launch file of ROS 1: a path relative to the scenario file, or package://PACKAGE/PATH. It is started"
        " in the car's namespace. Either this or `ros2` must be given.",
        default="",
    )
    interface: Interface = key(
        "`native`: the topics of the car's namespace; `f1tenth`: those of f1tenth_simulator and"
        " f1tenth_gym_ros (`/scan`, `/drive`, `/nav`, `/odom`, `/gt_pose`, `/ego_racecar/odom`,"
        " `/opp_scan`, …).",
        default=Interface.NATIVE,
    )
    arguments: dict[str, str] = key(
        "Values for arguments of the launch file, or NAME:=VALUE behind the command of `ros2`. One that names"
        " a file that is there, relative to the scenario file or as package://PACKAGE/PATH, is given as its"
        " path.",
        default={},
    )
    ros2: str = key(
        "Command that starts a planner of ROS 2, as in `ros2 launch my_package planner.launch.py`. It finds"
        " the topics of f1tenth_gym_ros.",
        default="",
    )

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        if bool(self.launch) == bool(self.ros2):
            found = "given beside" if self.ros2 else "missing, and so is"
            return "launch", f"is {found} 'ros2'; one of them is needed"
        if self.ros2 and self.interface is not Interface.NATIVE:
            return "interface", "is for a launch file; with 'ros2' the topics are those of f1tenth_gym_ros"
        return None

    @classmethod
    def short_forms(cls) -> dict[str, "Driver"]:
        """The drivers that we bring, by the names that stand for them."""
        return {
            "race": cls(f"{_OWN}/move_base.launch"),
            "pursuit": cls(f"{_OWN}/pure_pursuit.launch"),
            "commands": cls(f"{_OWN}/commands.launch"),
            "gap_follower": cls(f"{_OWN}/gap_follower.launch"),
        }

    def as_dict(self) -> dict[str, Any]:
        """As it is written in a scenario file."""
        launch = {"launch": self.launch, "interface": self.interface.value}
        entries = {"ros2": self.ros2} if self.ros2 else launch
        return entries | ({"arguments": dict(self.arguments)} if self.arguments else {})

    @property
    def is_ours(self) -> bool:
        """Whether it is one that we bring: it knows the topics of the F1/10 car, whatever it drives."""
        return self.launch.startswith(_OWN)

    @property
    def name(self) -> str:
        """The short form, else the launch file or the command."""
        names = (name for name, driver in self.short_forms().items() if driver.launch == self.launch)
        return self.ros2 or next(names, self.launch)
