"""What was done to the running simulation from outside, as the simulator noted it."""

import dataclasses
import json
from pathlib import Path
from typing import Any

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.files import reading


@dataclasses.dataclass(frozen=True)
class Intervention:
    """One call of a service, or one message, that changed the world or its time."""

    stamp: float  # s, simulated
    kind: str  # the service or topic of gazebo_ros, as in set_model_state
    caller: str  # name of the ROS node
    model: str  # empty: the whole world

    def describe(self) -> str:
        """Who did what, when."""
        what = f" for {self.model}" if self.model else ""
        return f"{self.caller} called {self.kind}{what} at {self.stamp:.3f} s"

    def as_json(self) -> dict[str, Any]:
        """As in the simulator's file."""
        return {"time": self.stamp, "kind": self.kind, "caller": self.caller, "model": self.model}


@dataclasses.dataclass(frozen=True)
class Jump(Intervention):
    """A car (`model`) was elsewhere in the next period, and nobody is known to have put it there."""

    way: float  # m
    turn: float  # rad
    period: float  # s

    def describe(self) -> str:
        """What happened, when."""
        how = f"moved by {self.way:.2f} m and {self.turn:.2f} rad within {self.period:g} s"
        return f"{self.model} {how} at {self.stamp:.3f} s, as no car can"


def read_interventions(path: Path) -> list[Intervention]:
    """Those of a run, in their order; none where the simulator has not begun.

    Raises:
        ScenarioError: the file is not the simulator's.
    """
    try:
        with reading(path) as stream:
            text = stream.read().decode()
    except FileNotFoundError:
        return []
    except (OSError, UnicodeDecodeError) as error:
        raise ScenarioError(f"{path}: cannot be read: {error}") from error
    complete = text[: text.rfind("\n") + 1].splitlines()
    return [_parse(line, f"{path}:{number}") for number, line in enumerate(complete, start=1)]


def _parse(line: str, place: str) -> Intervention:
    try:
        each = json.loads(line)
        return Intervention(float(each["time"]), each["kind"], each["caller"], each["model"])
    except (ValueError, TypeError, KeyError) as error:
        raise ScenarioError(f"{place}: not an intervention that the simulator noted") from error
