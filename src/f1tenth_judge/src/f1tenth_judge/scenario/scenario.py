"""What a scenario file says: the schema of `scenarios/NAME.yaml`."""

import dataclasses
import enum
from typing import Optional

from f1tenth_judge.scenario.car import TURN, Car
from f1tenth_judge.scenario.criteria import Criteria
from f1tenth_judge.scenario.interventions import Permission
from f1tenth_judge.yaml_files.schema import Problem, key

_GREATEST_PARAMETER = 2**31 - 1  # whole number that ROS's parameter server holds


class Verdict(enum.Enum):
    """How a run ended."""

    SUCCESS = "success"
    COLLISION = "collision"
    TIMEOUT = "timeout"
    ABORTED = "aborted"
    DISQUALIFIED = "disqualified"
    ERROR = "error"


class Localization(enum.Enum):
    """How the cars know where they are."""

    STATIC = "static"
    AMCL = "amcl"


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
    yaw: float = key("Heading of its length.", unit="rad", at_least=-TURN, at_most=TURN, default=0.0)
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
    load: float = key(
        "Wall time for which a driver may compute in a control period while it starts up, as numba and torch"
        " do; without lockstep, for which it may send no command at first.",
        unit="s",
        above=0,
        default=100.0,
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
class StartLine:
    """Where laps begin and end."""

    x: float = key("Middle of the line in the map frame.", unit="m", default=0.0)
    y: float = key("Middle of the line in the map frame.", unit="m", default=0.0)
    yaw: float = key(
        "Direction in which it is crossed.", unit="rad", at_least=-TURN, at_most=TURN, default=0.0
    )
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
    tags: tuple[str, ...] = key("Words by which pytest chooses scenarios, as in `-m fast`.", default=())
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
    pinned: bool = key(
        "Whether the libraries of every process are kept from choosing code by the processor, in lockstep.",
        default=True,
    )
    real_time_factor: float = key(
        "Simulated seconds per wall second without lockstep, where time waits for no driver to connect.",
        above=0,
        default=1.0,
    )
    localization: Localization = key(
        "From what the cars know where they are. `static`: perfect odometry; `amcl`: wheel odometry, and amcl"
        " on the map.",
        default=Localization.STATIC,
    )
    boxes: tuple[Box, ...] = key("Other objects besides the world's own models.", default=())
    criteria: Criteria = key("What the run is measured by besides its verdict.", default=Criteria())
    faults: tuple[Fault, ...] = key("What is broken on purpose.", default=())
    interventions: tuple[Permission, ...] = key(
        "What nodes may do to the running simulation by the services of gazebo_ros; anything else ends the"
        " run with the verdict `disqualified`.",
        default=(),
    )

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        names = [car.name for car in self.cars]
        if not names:
            return "cars", "is empty; at least one car is needed"
        if len(set(names)) != len(names):
            return "cars", f"has a name twice: {', '.join(names)}"
        if not all(tag.isidentifier() for tag in self.tags):
            return "tags", f"must be words of letters, digits and '_', found: {', '.join(self.tags)}"
        boxes = [box.name for box in self.boxes]
        if len({*boxes, *names}) != len(boxes) + len(names):
            return "boxes", f"has a name twice, or that of a car: {', '.join(boxes)}"
        if self.expected is Verdict.ERROR and self.culprit is None:
            return "culprit", "is missing; an expected error must say whose it is"
        if self.expected is not Verdict.ERROR and self.culprit is not None:
            return "culprit", "is for the expected verdict 'error' only"
        if any(fault.at > self.limits.timeout for fault in self.faults):
            return "faults", f"has a time after limits.timeout ({self.limits.timeout:g} s)"
        if any(fault.at > self.limits.timeout for car in self.cars for fault in car.input_faults):
            return "cars", f"has an input fault after limits.timeout ({self.limits.timeout:g} s)"
        if any(push.at > self.limits.timeout for box in self.boxes for push in box.pushes):
            return "boxes", f"has a push after limits.timeout ({self.limits.timeout:g} s)"
        return None

    @property
    def limits_of_reference(self) -> tuple[str, ...]:
        """Names of the criteria that are only reported, because another planner drives than theirs."""
        return () if any(car.driver.is_reference for car in self.cars) else self.criteria.of_reference

    @property
    def has_events(self) -> bool:
        """Whether something is to be done during the run."""
        return bool(self.faults) or any(box.pushes for box in self.boxes)
