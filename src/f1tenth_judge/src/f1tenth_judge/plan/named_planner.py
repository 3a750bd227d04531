"""A planner as a person names it: on the command line, in a test, in a league."""

import re
from collections.abc import Mapping
from pathlib import Path

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.scenario.driver import Driver, Interface

_CLASS = r".+\.py:\w+"
_POLICIES = Path(__file__).parents[1] / "drivers" / "python" / "policies.py"
_POLICY_CLASSES = {".onnx": "OnnxPolicy", ".zip": "Sb3Policy"}  # by the suffix of what they load
# Drivers that follow given commands need more than a road.
OUR_PLANNERS = ", ".join(name for name in Driver.short_forms() if name != "commands")
ALLOWED = (
    "a launch file, package://PACKAGE/PATH, FILE.py:CLASS, POLICY.onnx, POLICY.zip of stable-baselines3,"
    f" or one of ours: {OUR_PLANNERS}"
)


def named_planner(
    name: str,
    beside: Path,
    interface: Interface = Interface.NATIVE,
    arguments: Mapping[str, str] = {},  # noqa: B006
) -> Driver:
    """A planner by its name; a path is relative to the folder `beside`.

    Raises:
        ScenarioError: there is no such file.
    """
    ours = Driver.short_forms().get(name)
    try:
        if re.fullmatch(_CLASS, name):
            file, _, kind = name.rpartition(":")
            return Driver(python=f"{named_file(file, beside)}:{kind}", arguments=dict(arguments))
        if policy := _POLICY_CLASSES.get(Path(name).suffix):
            given = {"policy": named_file(name, beside), **arguments}
            return Driver(python=f"{_POLICIES}:{policy}", arguments=given)
        return Driver(ours.launch if ours else named_file(name, beside), interface, dict(arguments))
    except ScenarioError as error:
        raise ScenarioError(f"{name}: {error}; allowed: {ALLOWED}") from error


def named_file(name: str, beside: Path) -> str:
    """A file as a scenario file anywhere would name it.

    Raises:
        ScenarioError: there is no such file.
    """
    return name if name.startswith("package://") else str(lookup.file_at(name, beside))
