"""The simulation of a run, as a plan describes it, advanced one control period at a time."""

import copy
import functools
import hashlib
from pathlib import Path
from typing import NamedTuple, Optional, Union

import numpy as np
from f1tenth_sim2d.environments.xacro_file import expanded
from PIL import Image

import f1tenth_sim2d
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places.packages import package_path
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.planner import Eye, Picture
from f1tenth_judge.record.scene import lidar_of
from f1tenth_judge.said.said import Said
from f1tenth_judge.said.thumbnails import small
from f1tenth_judge.scenario.car import Car

PERIOD = 0.025  # s, of a scan
_STEP = 0.001  # s, of the simulation
_SAMPLES = 5  # of an IMU in a period
_CLEARANCE_LIMIT = 5.0  # m, as far as the record tells it


class DriveCommand(NamedTuple):
    """A speed (m/s) and a steering angle (rad, to the left)."""

    speed: float
    steering_angle: float


class TwistCommand(NamedTuple):
    """Velocities along the car and to its left (m/s), and its yaw rate (rad/s)."""

    linear_x: float
    angular_z: float
    linear_y: float = 0.0


Command = Union[DriveCommand, TwistCommand]


class Stage:
    """The world, the cars in it, and what has become of them."""

    def __init__(self, plan: Plan, said: Optional[Said] = None):
        """Load what the plan names; `said` keeps what planners say besides their commands.

        Raises:
            ScenarioError: the world or a car cannot be used.
        """
        try:
            self._world = f1tenth_sim2d.load_world(str(plan.run_world), [str(models_folder())])
            self._simulation = f1tenth_sim2d.Simulation(self._world, _STEP, plan.scenario.seed, PERIOD)
            self._ids = {car.name: self._add(plan, car) for car in plan.scenario.cars}
        except f1tenth_sim2d.Error as error:
            raise ScenarioError(str(error)) from error
        # As the simulator of ROS writes it at its end.
        self.inputs = {
            "physics_step": _STEP,
            "world_sha256": hashlib.sha256(plan.run_world.read_bytes()).hexdigest(),
            "cars_sha256": {car.name: _digest(plan, car) for car in plan.scenario.cars},
        }
        self.descriptions = {car: self._simulation.car(number) for car, number in self._ids.items()}
        self.said = said or Said()
        self.chances: list[str] = []  # by which the run is like no second one, in words
        self._imu: dict[str, list] = {car: [] for car in self._ids}
        self._periods = 0

    @property
    def world(self) -> f1tenth_sim2d.World:
        """What is simulated, without the cars."""
        return self._world

    @property
    def cars(self) -> list[str]:
        """Names of the cars."""
        return list(self._ids)

    @property
    def time(self) -> float:
        """Simulated time, s: the end of the last period."""
        return self._periods * PERIOD

    @property
    def gravity(self) -> float:
        """Of the world, m/s^2."""
        return self._world.gravity

    @property
    def states(self) -> dict[str, f1tenth_sim2d.CarState]:
        """The true state of each car."""
        return {car: self._simulation.state(number) for car, number in self._ids.items()}

    def lidar(self, car: str) -> Optional[f1tenth_sim2d.Lidar]:
        """The one that drivers use; None if the car has none."""
        return lidar_of(self.descriptions[car])

    def scan(self, car: str) -> Optional[tuple[f1tenth_sim2d.Lidar, np.ndarray]]:
        """The lidar of a car and what it measures now: ranges in m, float32, +inf where nothing is hit."""
        lidar = self.lidar(car)
        if lidar is None:
            return None
        names = [each.name for each in self.descriptions[car].lidars]
        return lidar, self._simulation.scan(self._ids[car], names.index(lidar.name))

    def eyes(self, car: str) -> list[Eye]:
        """Of which the cameras of a car are made, in the order of its description."""
        cameras = self.descriptions[car].cameras.items()
        return [
            Eye(camera, *(getattr(eye, part) for part in Eye._fields[1:]))
            for camera, eyes in cameras
            for eye in eyes
        ]

    def look(self, car: str, eye: Eye) -> Picture:
        """What an eye of a car sees now, kept small for the replay.

        The first look reads the files of all that can be seen.
        """
        picture = Picture(*self._simulation.look(self._ids[car], eye.camera, eye.name))
        topic = f"/{car}/{eye.camera}/{eye.name}"
        self.said.picture(topic, self.time, lambda: small(Image.fromarray(picture.colour)))
        return picture

    def look_warning(self) -> str:
        """What cameras do not see as it is described; empty: nothing."""
        return self._simulation.view_warning

    def imu_samples(self, car: str) -> list[tuple[float, f1tenth_sim2d.CarState]]:
        """What an exact IMU measured in the last period, with the times (s)."""
        return self._imu[car]

    def command(self, car: str, command: Command) -> None:
        """Tell a car what to do from now on.

        Raises:
            f1tenth_sim2d.Error: the numbers are not finite, or absurd; the car goes on as before.
        """
        simulation = self._simulation
        obey = simulation.command if isinstance(command, DriveCommand) else simulation.command_twist
        obey(self._ids[car], *command)

    def advance(self) -> None:
        """Simulate one control period."""
        for car, number in self._ids.items():
            self._simulation.clear_contacts(number)
            self._imu[car] = []
        for sample in range(1, _SAMPLES + 1):
            time = (self._periods + sample / _SAMPLES) * PERIOD
            self._simulation.advance_to(time)
            for car, number in self._ids.items():
                self._imu[car].append((time, self._simulation.state(number)))
        self._periods += 1

    def rows(self) -> list[tuple]:
        """What the record says of the last period: a row for each car, in the order of record.COLUMNS."""
        digest = self._simulation.trajectory_hash()
        return [self._row(car, digest) for car in self._ids]

    def _row(self, car: str, digest: str) -> tuple:
        number = self._ids[car]
        state, contacts = self._simulation.state(number), self._simulation.contacts(number)
        return (
            f"{self.time:.9f}",
            car,
            *(state.x, state.y, state.yaw, state.v_x, state.v_y, state.yaw_rate, state.steering_angle),
            self._simulation.clearance(number, _CLEARANCE_LIMIT),
            ";".join(sorted({each.other_model for each in contacts})),
            max((each.speed for each in contacts), default=0.0),
            digest,
        )

    def _add(self, plan: Plan, car: Car) -> int:
        start = plan.cars[car.name].start
        text, source = _description(plan, car)
        described = f1tenth_sim2d.load_car(text, car.name, source)
        return self._simulation.add_car(described, _parameters(car, described), start.x, start.y, start.yaw)


def _description(plan: Plan, car: Car) -> tuple[str, str]:
    """The URDF of a car, and its file."""
    own = plan.cars[car.name].description
    return (own.text, str(own.file)) if own else own_car()


def _digest(plan: Plan, car: Car) -> str:
    """Of the description of a car, and what the scenario changes of it."""
    changed = "".join(f"{name}: {getattr(car, name)}\n" for name in car.vehicle_changes())
    return hashlib.sha256((_description(plan, car)[0] + changed).encode()).hexdigest()


def _parameters(car: Car, described: f1tenth_sim2d.Car) -> f1tenth_sim2d.VehicleParameters:
    parameters = copy.copy(described.parameters)
    for name, value in car.vehicle_changes().items():
        setattr(parameters, name, value)
    return parameters


@functools.cache
def own_car() -> tuple[str, str]:
    """The description of the F1/10 car, and its file."""
    file = package_path("f1tenth_description") / "urdf" / "f1tenth.urdf.xacro"
    return expanded(file), str(file)


def models_folder() -> Path:
    """Where models of worlds are found by name."""
    return package_path("f1tenth_gazebo") / "models"
