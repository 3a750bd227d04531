"""A driver's launch file: which arguments it takes, and how it takes part in lockstep."""

import dataclasses
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Optional

from f1tenth_scenarios.errors import ScenarioError

# Its value, separated by blanks, names those who take part in lockstep; a deputy does so for all others.
_PARTICIPANTS = "participants"


@dataclasses.dataclass(frozen=True)
class DriverFile:
    """What is known of a driver before it is started."""

    path: Path
    arguments: frozenset[str]  # that may be given
    required: frozenset[str]  # that must be given
    participants: Optional[str] = None  # of lockstep, with $(arg car_name) in it

    def participants_of(self, car: str) -> Optional[list[str]]:
        """Names of docs/lockstep.md, for a car of this name; nothing when the file does not say."""
        if self.participants is None:
            return None
        return re.sub(r"\$\(arg car_name\)", car, self.participants).split()


def read_driver_file(path: Path) -> DriverFile:
    """Read what a launch file says of its arguments.

    Raises:
        ScenarioError: it cannot be read, or is no launch file.
    """
    try:
        root = ElementTree.parse(path).getroot()
    except (OSError, ElementTree.ParseError) as error:
        raise ScenarioError(f"{path}: not a launch file: {error}") from error
    if root.tag != "launch":
        raise ScenarioError(f"{path}: not a launch file: it begins with <{root.tag}>, must be <launch>")
    declared = {tag.get("name", ""): tag.attrib for tag in root.findall("arg")}
    open_ones = {name: attributes for name, attributes in declared.items() if "value" not in attributes}
    return DriverFile(
        path,
        frozenset(open_ones),
        frozenset(name for name, attributes in open_ones.items() if "default" not in attributes),
        declared.get(_PARTICIPANTS, {}).get("value"),
    )
