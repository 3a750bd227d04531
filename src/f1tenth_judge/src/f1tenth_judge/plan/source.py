"""Where a scenario is read from: a file of its own, or that of a circuit, which stands for a lap of it."""

from pathlib import Path
from typing import Callable

import yaml

from f1tenth_judge.errors import FileError, as_scenario_error
from f1tenth_judge.places.course import read_course
from f1tenth_judge.scenario.scenario import Scenario
from f1tenth_judge.scenario.yaml_text import compose_text
from f1tenth_judge.yaml_files.schema import read
from f1tenth_judge.yaml_files.yaml_source import compose

_SLOWEST = 0.5  # m/s on average, before the time is over
_STARTING = 30.0  # s, on top of that
_SEED = 1


@as_scenario_error(FileError)
def read_scenario(path: Path, change: Callable[[yaml.MappingNode], None] = lambda root: None) -> Scenario:
    """Read and validate a scenario file, or the file of a circuit, which stands for a lap of it.

    `change` may alter the file's content before that.

    Raises:
        ScenarioError: with the place and what is allowed there.
    """
    root = compose(path)
    # Every circuit has this key, and no scenario.
    if any(key.value == "corners" for key, _ in root.value):
        root = _scenario_of(path)
    change(root)
    return read(Scenario, root)


def _scenario_of(circuit: Path) -> yaml.MappingNode:
    """The scenario of a circuit, as a scenario file would have it."""
    description = {
        "description": f"One lap of {circuit.stem}, goal by goal without touching anything.",
        "world": circuit.stem,
        "cars": [{"name": "robot1"}],
        "limits": {"timeout": round(_STARTING + read_course(circuit).length / _SLOWEST, 1)},
        "expected": "success",
        "seed": _SEED,
    }
    return compose_text(yaml.safe_dump(description, sort_keys=False), str(circuit))
