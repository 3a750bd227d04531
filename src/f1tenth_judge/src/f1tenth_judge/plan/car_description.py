"""The robot description of a car: what its planner, its launch file and its judge must know of it."""

import dataclasses
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.scenario.car import Car, Input
from f1tenth_judge.scenario.scenario import Localization

# What a description says of the dynamics (f1tenth_sim2d/docs/loading.md); all else is the F1/10 car's.
_DYNAMICS = (
    "m",
    "l_f",
    "l_r",
    "h",
    "I_z",
    "mu",
    "steering_max",
    "steering_rate_max",
    "a_max",
    "v_min",
    "v_max",
)

_ODOMETRY, _TRUTH = "libf1tenth_perfect_odometry.so", "perfect_odom"  # the plugin, and its topic
_WHEELS = "odometry of its wheels with the transform from 'odom'"
_BASE = "base_footprint"


@dataclasses.dataclass(frozen=True)
class CarDescription:
    """A car of the user's own. Topics without a slash in front are in the namespace of the car."""

    file: Path
    text: str  # URDF, without macros
    scan: Optional[str]  # topic of its lidar; nothing if it has none
    scan_rate: float  # Hz
    twist: Optional[str]  # where it takes geometry_msgs/Twist; nothing if controllers of ros_control drive it
    takes_steering_angle: bool  # whether angular.z of that is the angle of its wheels, rad, not a yaw rate
    odometry: Optional[str]  # topic of what its wheels tell, if with the transform from `odom`
    odometry_period: Optional[float]  # s, of its true pose on `perfect_odom`; nothing if it has no such topic
    base_frame: str  # without prefix
    extent: tuple[float, float, float, float]  # its rear, front, right and left end in base_footprint, m
    dynamics: dict[str, float]  # keys of a car's YAML file, SI units

    def odometry_topic(self, localization: Localization) -> Optional[str]:
        """The topic that tells how the car moves: truly, or by its wheels if it is to localize itself."""
        knows_truth = self.odometry_period and localization is Localization.STATIC
        return _TRUTH if knows_truth else self.odometry

    @property
    def wheelbase(self) -> float:
        """In m."""
        return self.dynamics["l_f"] + self.dynamics["l_r"]

    @property
    def footprint(self) -> list[list[float]]:
        """Corners in base_footprint, m."""
        rear, front, right, left = self.extent
        return [[front, left], [front, right], [rear, right], [rear, left]]


def read_description(car: Car, beside: Path) -> Optional[CarDescription]:
    """Expand and read the description of a car, its path from `beside`; None for a car without its own.

    Raises:
        ScenarioError: there is no such file, or it describes no car; with the file and the place in it.
    """
    if car.description is None:
        return None
    file = lookup.file_at(car.description, beside)
    arguments = [f"{name}:={value}" for name, value in car.description_arguments.items()]
    return _read(file, arguments, car.name)


def _read(file: Path, arguments: Sequence[str], name: str) -> CarDescription:
    # Imported late, because most scenarios need neither, and importing takes time.
    import f1tenth_sim2d
    from f1tenth_judge.record.scene import lidar_of

    text = _expanded(file, arguments)
    try:
        described = f1tenth_sim2d.load_car(text, name, str(file))
    except f1tenth_sim2d.Error as error:
        raise ScenarioError(str(error)) from error
    lidar = lidar_of(described)
    return CarDescription(
        file=file,
        text=text,
        scan=lidar.topic if lidar else None,
        scan_rate=lidar.rate_hz if lidar else 0.0,
        twist=described.twist_topic,
        takes_steering_angle=described.takes_steering_angle,
        odometry=described.odometry_topic,
        odometry_period=_odometry_period(file, text),
        base_frame=described.base_frame,
        extent=described.extent,
        dynamics={key: getattr(described.parameters, key) for key in _DYNAMICS},
    )


def _odometry_period(file: Path, text: str) -> Optional[float]:
    plugins = ElementTree.fromstring(text).iter("plugin")
    for plugin in (each for each in plugins if each.get("filename") == _ODOMETRY):
        if plugin.findtext("odometryTopic", _TRUTH).strip() == _TRUTH:
            rate = plugin.findtext("updateRate", "200.0")
            try:
                return 1.0 / float(rate)
            except (ValueError, ZeroDivisionError) as error:
                why = f"<updateRate> of {_ODOMETRY} is '{rate}', must be above 0 Hz"
                raise ScenarioError(f"{file}: {why}") from error
    return None


def _expanded(file: Path, arguments: Sequence[str]) -> str:
    # In a virtual environment that is not activated it is no command of PATH.
    command = shutil.which("xacro") or shutil.which("xacro", path=str(Path(sys.executable).parent))
    if command is None:
        raise ScenarioError(f"{file}: xacro is not installed: pip install xacro")
    done = subprocess.run([command, str(file), *arguments], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        said = " ".join(done.stderr.partition("Check that:")[0].split()).removeprefix("error: ")
        raise ScenarioError(f"{file}: xacro: {said}")
    return done.stdout


def check_car(car: Car, description: CarDescription, localization: Localization) -> None:
    """Whether a car of this description can do what the scenario says.

    What a driver needs is known only of ours.

    Raises:
        ScenarioError: it lacks something.
    """
    driver = f"the driver '{car.driver.name}'"
    finds_itself = localization is Localization.AMCL
    drives_by_pose = car.driver.name in ("race", "pursuit")
    knows_truth = car.driver.name == "pursuit" or not finds_itself
    has_odometry = description.odometry_topic(localization) is not None
    needs = [
        (driver, "a lidar", car.driver.is_ours and not description.scan),
        (driver, "a car that takes geometry_msgs/Twist", car.driver.is_ours and not description.twist),
        (driver, _ODOMETRY, drives_by_pose and knows_truth and not description.odometry_period),
        (driver, _WHEELS, car.driver.name == "race" and finds_itself and not description.odometry),
        (driver, "a link base_footprint", car.driver.name == "race" and description.base_frame != _BASE),
        ("'dropped_beams'", "a lidar of 40 Hz", car.dropped_beams > 0 and description.scan_rate < 40.0),
        ("'input_faults'", "a lidar", bool(car.faults_of(Input.SCAN)) and not description.scan),
        ("'input_faults'", f"{_ODOMETRY} or {_WHEELS}", bool(car.faults_of(Input.ODOM)) and not has_odometry),
    ]
    for who, what, is_lacking in needs:
        if is_lacking:
            raise ScenarioError(f"{car.name}: {who} needs {what}, and {description.file} has none")


def check_topics(descriptions: Mapping[str, CarDescription]) -> None:
    """Whether each car has topics of its own.

    Raises:
        ScenarioError: two cars share one.
    """
    owners: dict[str, str] = {}
    for car, description in descriptions.items():
        for topic in filter(None, (description.scan, description.twist)):
            if not topic.startswith("/"):
                continue
            if topic in owners:
                raise ScenarioError(
                    f"{car}: {description.file} has the topic {topic}, as {owners[topic]} has; write it"
                    " without the slash in front, or let it depend on 'description_arguments'"
                )
            owners[topic] = car
