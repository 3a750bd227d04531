"""A scenario with everything that it names found and read: ready to run."""

import dataclasses
from pathlib import Path
from typing import Optional

from f1tenth_judge.places.course import Course
from f1tenth_judge.places.place import Place
from f1tenth_judge.plan.car_plan import CarPlan
from f1tenth_judge.plan.task import Task
from f1tenth_judge.scenario.car import Pose
from f1tenth_judge.scenario.scenario import Scenario


@dataclasses.dataclass(frozen=True)
class Plan:
    """What a run needs to know."""

    name: str
    file: Path
    scenario: Scenario
    place: Place
    cars: dict[str, CarPlan]
    folder: Path  # for the results
    course: Optional[Course] = None
    settings: tuple[str, ...] = ()  # KEY=VALUE, set from outside of the file
    keep_bag: bool = False  # also if the run passes
    watched: bool = False  # it uses the running ROS master, so that somebody can watch
    note: str = ""  # why the run differs from what the scenario asks for

    @property
    def tasks(self) -> dict[str, Task]:
        """Per car, what it has to do."""
        return {name: car.task for name, car in self.cars.items()}

    @property
    def goals(self) -> dict[str, tuple[Pose, ...]]:
        """Per car that has goals, those of one lap."""
        return {name: car.goals for name, car in self.cars.items() if car.goals}

    @property
    def driver_folders(self) -> dict[str, Path]:
        """Per car, where its driver is."""
        return {name: car.driver.folder for name, car in self.cars.items()}

    def goals_file(self, car: str) -> Optional[Path]:
        """Where the goals of a car are; goals that are in no file are written into the log folder."""
        planned = self.cars[car]
        return planned.goals_file or (self.log_folder / f"{car}_goals.txt" if planned.goals else None)

    @property
    def run_world(self) -> Path:
        """The world that is simulated: with the scenario's boxes."""
        return self.log_folder / "boxes.world" if self.scenario.boxes else self.place.world

    @property
    def needs_ros(self) -> bool:
        """Whether a driver is a launch file of ROS 1."""
        return any(car.driver.launch for car in self.scenario.cars)

    @property
    def has_countdown(self) -> bool:
        """Whether somebody waits for a start signal."""
        return any(car.driver.needs_countdown for car in self.cars.values())

    def description_file(self, car: str) -> Path:
        """The URDF of a car that has a description of its own."""
        return self.log_folder / f"{car}.urdf"

    def vehicle_file(self, car: str) -> Path:
        """Parameters of a car that differ from those of its description."""
        return self.log_folder / f"{car}.yaml"

    @property
    def log_folder(self) -> Path:
        """Where the processes write."""
        return self.folder / "log"

    @property
    def record_file(self) -> Path:
        """What the simulator records, uncut."""
        return self.log_folder / "record.csv"

    @property
    def interventions_file(self) -> Path:
        """What was done to the running simulation, as the simulator notes it."""
        return self.log_folder / "interventions.jsonl"

    @property
    def bag_file(self) -> Path:
        """What was published on topics."""
        return self.log_folder / "run.bag"

    @property
    def simulator_result_file(self) -> Path:
        """What the simulator says at its end."""
        return self.log_folder / "simulator.json"

    @property
    def launch_file(self) -> Path:
        """What roslaunch starts."""
        return self.log_folder / "run.launch"

    @property
    def launch_log(self) -> Path:
        """The output of roslaunch, and what the nodes write to stderr."""
        return self.log_folder / "roslaunch.log"
