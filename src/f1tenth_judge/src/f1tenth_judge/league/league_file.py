"""What the file of a league says."""

import dataclasses
from pathlib import Path
from typing import Optional

from f1tenth_judge.errors import FileError, as_scenario_error
from f1tenth_judge.plan.named_planner import named_planner
from f1tenth_judge.scenario.driver import Driver, Interface
from f1tenth_judge.yaml_files.schema import Problem, key, read
from f1tenth_judge.yaml_files.yaml_source import compose


@dataclasses.dataclass(frozen=True)
class Entry:
    """A planner that takes part."""

    name: str = key("Of letters, digits and '_'.")
    planner: str = key(
        "As `--planner` names it; a path is relative to the file of the league. This or `ros2` is given.",
        default="",
    )
    ros2: str = key("Command that starts a planner of ROS 2.", default="")
    interface: Interface = key("Topics of a launch file.", default=Interface.NATIVE)
    arguments: dict[str, str] = key("For the planner.", default={})
    given: Optional[Driver] = None  # who was found already

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        if bool(self.planner) == bool(self.ros2):
            return "planner", "or 'ros2' must be given, and not both"
        fits = self.name.isidentifier()
        return None if fits else ("name", f"is '{self.name}', must be of letters, digits and '_'")

    @property
    def driven_by(self) -> str:
        """The planner as it was named."""
        return self.given.name if self.given else self.planner or self.ros2

    def driver(self, beside: Path) -> Driver:
        """How it is started; `beside`: the folder of the league's file.

        Raises:
            ScenarioError: there is no such file.
        """
        if self.given:
            return self.given
        if self.ros2:
            return Driver(ros2=self.ros2, arguments=self.arguments)
        return named_planner(self.planner, beside, self.interface, self.arguments)


@dataclasses.dataclass(frozen=True)
class League:
    """Who races where, and how often."""

    planners: tuple[Entry, ...] = key("Who takes part.")
    places: tuple[str, ...] = key("Circuits, worlds or maps; a path is relative to the file.")
    laps: int = key("Of a race.", at_least=1, default=1)
    seeds: tuple[int, ...] = key("A race for each.", default=(1,))
    pairs: bool = key("Whether each planner races each other one as well.", default=False)

    def problem(self) -> Problem:
        """What is wrong between the keys: the key and the text, or nothing."""
        names = [entry.name for entry in self.planners]
        for each in ("planners", "places", "seeds"):
            values = names if each == "planners" else getattr(self, each)
            if not values:
                return each, "is empty; at least one is needed"
            if len(set(values)) != len(values):
                return each, f"has one twice: {', '.join(map(str, values))}"
        return None


@as_scenario_error(FileError)
def read_league(path: Path) -> League:
    """Read the file of a league.

    Raises:
        ScenarioError: with the place and what is allowed there.
    """
    return read(League, compose(path))
