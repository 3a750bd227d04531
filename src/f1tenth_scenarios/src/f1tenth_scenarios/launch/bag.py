"""The bag of a run: what was published on its topics, written by the node bag_recorder during the run."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

RECORDER = "scenario_recorder"  # the node that writes it

_SHARED_TOPICS = ("/clock", "/tf", "/tf_static", "/map", "/time_to_start", "/gazebo/model_states")
# Of a car; heard from the start, before they are published. What else its nodes publish and hear is found.
_CAR_TOPICS = (
    "scan",
    "odom",
    "perfect_odom",
    "joint_states",
    "bumper_front",
    "bumper_rear",
    "bumper_left",
    "bumper_right",
    "collision",
    "collisions",
    "cmd_vel",
    "drive",
    "amcl_pose",
    "particlecloud",
    "race_status",
    "race_goals",
    "move_base/goal",
    "move_base/cancel",
    "move_base/status",
    "move_base/feedback",
    "move_base/result",
    "move_base/current_goal",
    "move_base/global_plan",
    "move_base/local_plan",
)


def recorder_parameters(bag: Path, cars: Sequence[str], more: Sequence[str] = ()) -> dict[str, Any]:
    """The private parameters of the recorder; `more`: topics that are heard from the start besides."""
    topics = [*_SHARED_TOPICS, *(f"/{car}/{topic}" for car in cars for topic in _CAR_TOPICS), *more]
    return {"bag": str(bag), "dropped": str(_dropped_file(bag)), "cars": list(cars), "topics": topics}


def dropped(bag: Path) -> list[str]:
    """The topics of planners that the bag holds only until they reached the limit of its size, in words."""
    file = _dropped_file(bag)
    return file.read_text(encoding="utf-8").splitlines() if file.exists() else []


def _dropped_file(bag: Path) -> Path:
    return bag.with_suffix(".dropped")
