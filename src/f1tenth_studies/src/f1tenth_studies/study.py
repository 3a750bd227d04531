"""What a study is: a scenario that is swept, and a table of the outcomes."""

import dataclasses
import functools
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Callable, Optional

from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.record.files import TRAJECTORY_FILE
from f1tenth_judge.record.record import Record, read_record
from f1tenth_judge.scenario.settings import parse_setting


@dataclasses.dataclass(frozen=True)
class Run:
    """One run of a sweep."""

    values: Mapping[str, str]  # of the varied keys
    result: Mapping[str, Any]  # its result.json
    folder: Path  # of its results

    @property
    def lap_times(self) -> Sequence[float]:
        """Of robot1, s."""
        return self.result["cars"]["robot1"]["lap_times"]

    @property
    def clearance(self) -> float:
        """The least of any car, m."""
        return self.result["minimum_clearance"] or 0.0

    @property
    def contacts(self) -> int:
        """How often something was touched."""
        return len(self.result["contacts"])

    def actual(self, criterion: str) -> float:
        """What was measured for a criterion; infinite if nothing was."""
        found = {each["name"]: each["actual"] for each in self.result["criteria"]}[criterion]
        return float("inf") if found is None else found

    @property
    def broke_down(self) -> bool:
        """Whether something other than a car ended it: maybe before the record of any car began."""
        return self.result["verdict"] == "error"

    @functools.cached_property
    def record(self) -> Record:
        """What the cars did."""
        return read_record(self.folder / TRAJECTORY_FILE)

    def failure(self) -> str:
        """What makes a run of any study not good enough; empty if nothing does."""
        if self.result["verdict"] != "success":
            return self.result["reason"]
        return f"{self.contacts} contacts, must be none" if self.contacts else ""


@dataclasses.dataclass(frozen=True)
class Column:
    """One column of the table."""

    head: str  # with the unit
    value: Callable[[Sequence[Run]], Any]  # from the runs of a row
    digits: int = 3  # of a number that is not whole


@dataclasses.dataclass(frozen=True)
class Study:
    """A scenario to sweep and a table to make of it."""

    title: str
    text: str  # Markdown: what is measured, what is wanted
    scenario: str  # file in this package's folder `scenarios`
    vary: Mapping[str, str]  # values by key, as `scenario sweep --vary` reads them
    rows: tuple[str, ...]  # the varied keys that make a row; runs that differ in others share one
    columns: tuple[Column, ...]
    # Why a run that did not fail is still not good enough; empty when it is.
    defect: Callable[[Run], str] = lambda run: ""
    # The varied key that stands for places, and a function that writes worlds for its values to a folder.
    places: Optional[tuple[str, Callable[[str, Path], Iterable[Path | str]]]] = None
    # Further names for rows, from the values of a run.
    labels: Callable[[Mapping[str, str]], Mapping[str, str]] = lambda values: {}

    def varied(self, given: Iterable[str]) -> dict[str, str]:
        """What to vary: the given KEY=VALUES, which replace the study's own.

        Raises:
            ScenarioError: one is not of this form, or of a key that rows and columns do not know of.
        """
        own: dict[str, str] = {}
        for setting in map(parse_setting, given):
            if setting.key not in self.vary:
                allowed = ", ".join(self.vary)
                raise ScenarioError(f"--vary {setting}: is not varied by this study, allowed: {allowed}")
            if setting.key in own:
                raise ScenarioError(f"--vary {setting}: is varied more than once")
            own[setting.key] = setting.value
        return {**self.vary, **own}

    def expect_others(self, settings: Iterable[str]) -> None:
        """Refuse a KEY=VALUE that would be overwritten in every run.

        Raises:
            ScenarioError: there is one, or one is not of this form.
        """
        keys = {*self.vary, *(["world"] if self.places else [])}
        for setting in map(parse_setting, settings):
            if setting.key in keys:
                raise ScenarioError(f"--set {setting}: is what this study varies, by {', '.join(self.vary)}")

    def make(self, vary: Mapping[str, str], folder: Path) -> Mapping[str, str]:
        """Write the places that the runs need to a folder.

        Returns what to vary: `vary` with worlds in place of the places' key.

        Raises:
            ScenarioError: values could not be told apart, as the folder's path has what separates them.
        """
        if not self.places:
            return vary
        if {",", ":"} & set(str(folder)):
            raise ScenarioError(f"--results: {folder} is among values, must be without ',' and ':'")
        key, worlds = self.places
        with writing(folder):
            folder.mkdir(parents=True, exist_ok=True)
        made = {**vary, "world": ",".join(map(str, worlds(vary[key], folder)))}
        if key != "world":
            del made[key]
        return made

    def about(self, values: Mapping[str, str]) -> Mapping[str, str]:
        """Names for rows: the values of a run, and its place, also under the key that stands for it."""
        place = place_of(values)
        key = self.places[0] if self.places else "place"
        return {"place": place, key: place, **values, **self.labels(values)}

    def problem(self, run: Run) -> str:
        """Why a run is not good enough; empty when it is."""
        return run.failure() or self.defect(run)


def slowest(runs: Sequence[Run]) -> float:
    """The slowest lap, s; infinite without one."""
    return max((time for run in runs for time in run.lap_times), default=float("inf"))


def place_of(values: Mapping[str, str]) -> str:
    """Name of the place that was driven on; empty if there is no choice."""
    return Path(values.get("world", "")).stem.removesuffix("_map")


def failed_places(runs: Sequence[Run]) -> str:
    """Names of the places that failed."""
    return ", ".join(place_of(run.values) for run in runs if run.failure())


CLEARANCE = Column("least clearance (m)", lambda runs: min(run.clearance for run in runs))
CONTACTS = Column("contacts", lambda runs: sum(run.contacts for run in runs))
