"""What a scenario file says of a car: the schema of `cars`."""

import dataclasses
import enum
import re
from bisect import bisect_right
from collections.abc import Sequence
from typing import Any, Optional

from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.yaml_files.schema import Problem, key

_NAMES_OF_THE_SIMULATOR = ("gazebo", "sim2d")  # namespaces at the root that are not a car's


class VehicleModel(enum.Enum):
    """How a car moves: `model` in its YAML file."""

    KINEMATIC = "kinematic"
    SINGLE_TRACK = "single_track"
    SINGLE_TRACK_DRIFT = "single_track_drift"


TURN = 6.284
"""rad, a whole one, rounded up; a greater yaw is in degrees by mistake"""


@dataclasses.dataclass(frozen=True)
class Pose:
    """A pose in the map frame."""

    x: float = key("Position in the map frame.", unit="m")
    y: float = key("Position in the map frame.", unit="m")
    yaw: float = key(
        "Heading, counter-clockwise from the x axis.", unit="rad", at_least=-TURN, at_most=TURN, default=0.0
    )


@dataclasses.dataclass(frozen=True)
class Command:
    """What a car is told from a moment on."""

    at: float = key("Simulated time from which the command holds.", unit="s", at_least=0)
    speed: float = key("Speed along the car.", unit="m/s", at_least=-5, at_most=20)
    steering_angle: float = key(
        "Steering angle, left is positive.", unit="rad", at_least=-0.4189, at_most=0.4189, default=0.0
    )


STANDING = Command(at=0.0, speed=0.0)


def command_at(commands: Sequence[Command], now: float) -> Command:
    """The command that holds at a time (s): the last one begun; standing before the first."""
    begun = bisect_right([command.at for command in commands], now + 1e-9)
    return commands[begun - 1] if begun else STANDING


class Input(enum.Enum):
    """An input of planners."""

    SCAN = "scan"
    ODOM = "odom"
    TF = "tf"


@dataclasses.dataclass(frozen=True)
class InputFault:
    """A time in which inputs of a planner come late or not at all."""

    inputs: tuple[Input, ...] = key("What is concerned: the lidar, the odometry, the transforms.")
    at: float = key("Simulated time at which it begins.", unit="s", at_least=0)
    until: float = key("Simulated time at which it is over.", unit="s", above=0)
    delay: Optional[float] = key(
        "By how much each message is late; none: all are lost.", unit="s", above=0, default=None
    )

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        if not self.inputs:
            return "inputs", f"is empty; allowed: {', '.join(each.value for each in Input)}"
        if self.until <= self.at:
            return "until", f"is {self.until:g}, must be after 'at' ({self.at:g} s)"
        return None


@dataclasses.dataclass(frozen=True)
class Car:
    """One car of a scenario."""

    name: str = key("Name and ROS namespace of the car.")
    start: Optional[Pose] = key(
        "Where the car's base_footprint is put; default: on the start line of the circuit or track, else at"
        " the origin.",
        default=None,
    )
    ahead: Optional[float] = key(
        "How far along the middle of the road from the start line the car is put, in the place of `start`.",
        unit="m",
        default=None,
    )
    driver: Driver = key(
        "Who drives. `race`: move_base and race_mgr drive to the goals; `pursuit`: pure pursuit of a line;"
        " `commands`: a fixed command profile; `gap_follower`: steers into the widest gap; any other planner:"
        " its launch file.",
        default=Driver.short_forms()["race"],
    )
    goals: Optional[str] = key(
        "Goals to be passed in order: a name under goals/ without .txt, or the path of a goals file relative"
        " to the scenario file; default for the driver `race`: those of the circuit that is the world.",
        default=None,
    )
    laps: Optional[int] = key(
        "Laps to be driven, counted at the start line; goals are then only what the driver is given.",
        at_least=1,
        default=None,
    )
    line: Optional[str] = key(
        "What the driver `pursuit` follows: a circuit under circuits/ without .yaml (its middle), or the path"
        " of an X_raceline.csv or X_centerline.csv; default: the raceline beside the map, else the middle of"
        " the road.",
        default=None,
    )
    speed_max: Optional[float] = key(
        "How fast the driver may go, if it has an argument of this name; default: what it is set to.",
        unit="m/s",
        above=0,
        at_most=20,
        default=None,
    )
    acceleration_max: Optional[float] = key(
        "How hard the driver may speed up, brake and take bends, if it has an argument of this name; default:"
        " what it is set to.",
        unit="m/s^2",
        above=0,
        at_most=20,
        default=None,
    )
    description: Optional[str] = key(
        "Robot description of a car of your own, with the tags of Gazebo: the path of a URDF or xacro file"
        " relative to the scenario file, or package://PACKAGE/PATH; default: the F1/10 car.",
        default=None,
    )
    description_arguments: dict[str, str] = key("Values for arguments of its xacro file.", default={})
    commands: tuple[Command, ...] = key("What the driver `commands` does, in order of time.", default=())
    mu: Optional[float] = key(
        "Friction of the car's tyres on the ground; default: the car's.", above=0, at_most=3, default=None
    )
    actuation_latency: Optional[float] = key(
        "How long after a command the car begins to follow it; default: the car's.",
        unit="s",
        at_least=0,
        at_most=1,
        default=None,
    )
    model: Optional[VehicleModel] = key(
        "How the car moves, by the name of a vehicle model; default: the car's.", default=None
    )
    dropped_beams: float = key(
        "Probability of each beam of the planner's lidar to be lost.", at_least=0, at_most=1, default=0.0
    )
    input_faults: tuple[InputFault, ...] = key("When the planner's inputs fail.", default=())

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", self.name):
            return "name", f"is '{self.name}', must be a letter followed by letters, digits and underscores"
        if self.name in _NAMES_OF_THE_SIMULATOR:
            return "name", f"is '{self.name}', must be none of {', '.join(_NAMES_OF_THE_SIMULATOR)}"
        if self.start and self.ahead is not None:
            return "ahead", "is given beside 'start'; the car can be put in one place only"
        if self.description_arguments and not self.description:
            return "description_arguments", "is given without 'description'"
        times = [command.at for command in self.commands]
        if times != sorted(set(times)):
            return "commands", "must be in order of time ('at'), each time once"
        return self._problem_of_inputs()

    def vehicle_changes(self) -> dict[str, Any]:
        """What the scenario changes of the parameters of its vehicle, by their names there."""
        model = None if self.model is None else self.model.value
        named = {"mu": self.mu, "actuation_latency": self.actuation_latency, "model": model}
        return {name: value for name, value in named.items() if value is not None}

    def faults_of(self, name: Input) -> list[InputFault]:
        """What befalls an input, in order of time."""
        faults = (fault for fault in self.input_faults if name in fault.inputs)
        return sorted(faults, key=lambda fault: fault.at)

    def _problem_of_inputs(self) -> Problem:
        if self.dropped_beams and self.faults_of(Input.SCAN):
            return "input_faults", "cannot concern a scan with 'dropped_beams'"
        for name in Input:
            faults = self.faults_of(name)
            if any(later.at < earlier.until for earlier, later in zip(faults, faults[1:])):
                return "input_faults", f"overlap for '{name.value}'"
        return None
