"""What a scenario file says: the schema of `scenarios/NAME.yaml`."""

import dataclasses
import enum
import re
from typing import Optional

from f1tenth_scenarios.scenario.driver import Driver
from f1tenth_scenarios.scenario.schema import key

Problem = Optional[tuple[str, str]]

_GREATEST_PARAMETER = 2**31 - 1  # whole number that ROS's parameter server holds
_NAMES_OF_THE_SIMULATOR = ("gazebo", "sim2d")  # namespaces at the root that are not a car's


class Verdict(enum.Enum):
    """How a run ended."""

    SUCCESS = "success"
    COLLISION = "collision"
    TIMEOUT = "timeout"
    ABORTED = "aborted"
    ERROR = "error"


class VehicleModel(enum.Enum):
    """How a car moves: `model` in its YAML file."""

    KINEMATIC = "kinematic"
    SINGLE_TRACK = "single_track"
    SINGLE_TRACK_DRIFT = "single_track_drift"


class Localization(enum.Enum):
    """From what the cars know where they are."""

    STATIC = "static"
    AMCL = "amcl"


@dataclasses.dataclass(frozen=True)
class Pose:
    """A pose in the map frame."""

    x: float = key("Position in the map frame.", unit="m")
    y: float = key("Position in the map frame.", unit="m")
    yaw: float = key("Heading, counter-clockwise from the x axis.", unit="rad", default=0.0)


@dataclasses.dataclass(frozen=True)
class Command:
    """What a car is told from a moment on."""

    at: float = key("Simulated time from which the command holds.", unit="s", at_least=0)
    speed: float = key("Speed along the car.", unit="m/s", at_least=-5, at_most=20)
    steering_angle: float = key(
        "Steering angle, left is positive.", unit="rad", at_least=-0.4189, at_most=0.4189, default=0.0
    )


class Input(enum.Enum):
    """What a planner drives by."""

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
    commands: tuple[Command, ...] = key("What the driver `commands` does, in order of time.", default=())
    mu: Optional[float] = key(
        "Friction of the car's tyres on the ground; default: the car's.", above=0, at_most=3, default=None
    )
    model: Optional[VehicleModel] = key(
        "How the car moves: `kinematic`; `single_track`, tyres without a limit; `single_track_drift`,"
        " tyres that slide; default: the car's.",
        default=None,
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
        times = [command.at for command in self.commands]
        if times != sorted(set(times)):
            return "commands", "must be in order of time ('at'), each time once"
        return self._problem_of_inputs()

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


@dataclasses.dataclass(frozen=True)
class Push:
    """A velocity that a box is given."""

    at: float = key("Simulated time at which it happens.", unit="s", at_least=0)
    speed: float = key("How fast the box is then; the ground brakes it.", unit="m/s", above=0)
    direction: float = key("In which direction of the map frame.", unit="rad", default=0.0)


@dataclasses.dataclass(frozen=True)
class Box:
    """A box on the ground that is in no map."""

    name: str = key("Name of the model.")
    x: float = key("Middle in the map frame.", unit="m")
    y: float = key("Middle in the map frame.", unit="m")
    yaw: float = key("Heading of its length.", unit="rad", default=0.0)
    length: float = key("Size.", unit="m", above=0, default=0.4)
    width: float = key("Size.", unit="m", above=0, default=0.4)
    height: float = key("Size.", unit="m", above=0, default=0.5)
    movable: bool = key("Whether it can be pushed.", default=False)
    mass: float = key("Mass, if it can be pushed.", unit="kg", above=0, default=1.0)
    pushes: tuple[Push, ...] = key("When and how it is pushed during the run.", default=())

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        if self.pushes and not self.movable:
            return "pushes", "is for a box that is movable"
        return None


@dataclasses.dataclass(frozen=True)
class Limits:
    """When a run is over at the latest."""

    timeout: float = key("Simulated time after which the verdict is `timeout`.", unit="s", above=0)
    answer: float = key(
        "Wall time in which each participant of lockstep must answer a control period, and a process that is"
        " stopped must go on if simulated time stands.",
        unit="s",
        above=0,
        default=20.0,
    )
    silence: float = key(
        "Simulated time for which a driver may send no command at all; `race` may stand as long as it likes.",
        unit="s",
        above=0,
        default=10.0,
    )
    wall: float = key(
        "Wall time after which the run counts as hung and the verdict is `error`.",
        unit="s",
        above=0,
        default=300.0,
    )


@dataclasses.dataclass(frozen=True)
class Criteria:
    """What a run is measured by besides its verdict."""

    goal_tolerance: float = key(
        "A goal counts as passed within this distance.", unit="m", above=0, default=0.5
    )
    goal_yaw_tolerance: float = key(
        "A goal counts as passed within this difference of heading.",
        unit="rad",
        above=0,
        at_most=3.1416,
        default=0.8,
    )
    light_touch: float = key(
        "Contacts slower than this are no collision.", unit="m/s", at_least=0, default=0.0
    )
    minimum_clearance: Optional[float] = key(
        "No car may come closer to anything than this.", unit="m", at_least=0, default=None
    )
    lap_time: Optional[float] = key("No lap may take longer.", unit="s", above=0, default=None)
    lateral_acceleration: Optional[float] = key(
        "No car may be pushed to the side harder than this.", unit="m/s^2", above=0, default=None
    )
    off_course: Optional[float] = key(
        "No car's base_footprint may leave the road of `course` by more than this.",
        unit="m",
        at_least=0,
        default=None,
    )
    standstill: Optional[float] = key(
        "No car may stand still for longer after the start.", unit="s", at_least=0, default=None
    )
    slows_to: Optional[float] = key(
        "Each car must, once it has been faster, come down to this speed; a car that is to stop.",
        unit="m/s",
        above=0,
        default=None,
    )
    localization_error: Optional[float] = key(
        "Largest distance between `amcl_pose` and the truth (RMS).", unit="m", above=0, default=None
    )
    localization_yaw_error: Optional[float] = key(
        "Largest difference of heading between `amcl_pose` and the truth (RMS).",
        unit="rad",
        above=0,
        default=None,
    )
    real_time_factor: Optional[float] = key(
        "Least simulated seconds per wall second; depends on the machine.", above=0, default=None
    )


@dataclasses.dataclass(frozen=True)
class StartLine:
    """Where laps begin and end."""

    x: float = key("Middle of the line in the map frame.", unit="m", default=0.0)
    y: float = key("Middle of the line in the map frame.", unit="m", default=0.0)
    yaw: float = key("Direction in which it is crossed.", unit="rad", default=0.0)
    width: float = key("Length of the line.", unit="m", above=0, default=3.0)


@dataclasses.dataclass(frozen=True)
class Fault:
    """Something that is broken on purpose."""

    kill: str = key("Node that is killed (SIGKILL), as in `robot1/move_base`.")
    at: float = key("Simulated time at which it happens.", unit="s", at_least=0)


@dataclasses.dataclass(frozen=True)
class Scenario:
    """One test case."""

    description: str = key("One sentence that says what is tested.")
    world: str = key(
        "A name under f1tenth_gazebo/worlds without .world, or a path relative to the scenario file."
    )
    cars: tuple[Car, ...] = key("The cars, each with its driver.")
    limits: Limits = key("When the run is over at the latest.")
    expected: Verdict = key("The verdict that makes the scenario pass.")
    seed: int = key("Seed of all noise.", at_least=0, at_most=_GREATEST_PARAMETER)
    culprit: Optional[str] = key(
        "Node that an expected `error` must name, as in `robot1/move_base`; required then.", default=None
    )
    reason: Optional[str] = key("Words that the reason of the verdict must hold.", default=None)
    course: Optional[str] = key(
        "The road: a circuit under f1tenth_gazebo/circuits without .yaml, or the path of an X_centerline.csv"
        " relative to the scenario file.",
        default=None,
    )
    start_line: Optional[StartLine] = key(
        "Where laps are timed; without it a lap ends with its last goal.", default=None
    )
    laps: int = key("How often the goals are driven through.", at_least=1, default=1)
    time_to_start: int = key("Countdown before the start.", unit="s", at_least=0, default=2)
    lockstep: bool = key("Whether the simulator waits for every participant in every period.", default=True)
    real_time_factor: float = key(
        "Simulated seconds per wall second without lockstep; 0: as fast as it goes.", at_least=0, default=1.0
    )
    localization: Localization = key(
        "From what the cars know where they are. `static`: perfect odometry; `amcl`: wheel odometry, and amcl"
        " on the map.",
        default=Localization.STATIC,
    )
    boxes: tuple[Box, ...] = key("What lies about besides the world's own models.", default=())
    criteria: Criteria = key("What the run is measured by besides its verdict.", default=Criteria())
    faults: tuple[Fault, ...] = key("What is broken on purpose.", default=())

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        names = [car.name for car in self.cars]
        if not names:
            return "cars", "is empty; at least one car is needed"
        if len(set(names)) != len(names):
            return "cars", f"has a name twice: {', '.join(names)}"
        boxes = [box.name for box in self.boxes]
        if len({*boxes, *names}) != len(boxes) + len(names):
            return "boxes", f"has a name twice, or that of a car: {', '.join(boxes)}"
        if self.expected is Verdict.ERROR and self.culprit is None:
            return "culprit", "is missing; an expected error must say whose it is"
        if self.expected is not Verdict.ERROR and self.culprit is not None:
            return "culprit", "is for the expected verdict 'error' only"
        if self.criteria.off_course is not None and self.course is None:
            return "course", "is missing; the criterion 'off_course' needs it"
        if any(fault.at > self.limits.timeout for fault in self.faults):
            return "faults", f"has a time after limits.timeout ({self.limits.timeout:g} s)"
        if any(fault.at > self.limits.timeout for car in self.cars for fault in car.input_faults):
            return "cars", f"has an input fault after limits.timeout ({self.limits.timeout:g} s)"
        if any(push.at > self.limits.timeout for box in self.boxes for push in box.pushes):
            return "boxes", f"has a push after limits.timeout ({self.limits.timeout:g} s)"
        return None

    @property
    def has_events(self) -> bool:
        """Whether something is to be done during the run."""
        return bool(self.faults) or any(box.pushes for box in self.boxes)
