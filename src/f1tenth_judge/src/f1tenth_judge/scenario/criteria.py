"""What a scenario file says of its verdict: the schema of `criteria`."""

import dataclasses
from typing import Optional

from f1tenth_judge.yaml_files.schema import Problem, key

_OF_REFERENCE = ("minimum_clearance", "lap_time", "lateral_acceleration", "standstill")


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
    off_road: float = key(
        "No car's base_footprint may be farther beyond the edge of the road, where the road is known.",
        unit="m",
        at_least=0,
        default=0.1,
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
    odometry_drift: Optional[float] = key(
        "Where `visual_odom` leads to, from its first pose to its last, may be farther from the truth by at"
        " most this share of the way.",
        above=0,
        default=None,
    )
    real_time_factor: Optional[float] = key(
        "Least simulated seconds per wall second; depends on the machine.", above=0, default=None
    )
    of_reference: tuple[str, ...] = key(
        "Which of minimum_clearance, lap_time, lateral_acceleration and standstill are those of `race`:"
        " of another planner they are reported, not judged.",
        default=(),
    )

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        given = [name for name in _OF_REFERENCE if getattr(self, name) is not None]
        if others := [name for name in self.of_reference if name not in given]:
            return (
                "of_reference",
                f"has '{others[0]}', must be limits that are given: {', '.join(given) or 'none'}",
            )
        return None
