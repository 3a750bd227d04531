"""Running races and scenarios, each in a process of its own."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Optional

from f1tenth_judge.api.run import Run
from f1tenth_judge.batch.jobs import Job, run_job
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.extensions import extensions
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.named_planner import named_planner
from f1tenth_judge.plan.planner import planner_setting
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.plan.race import Race, plan_race, save_race
from f1tenth_judge.run.ros import GROUP, require_runner
from f1tenth_judge.scenario.driver import Driver, Interface

_RACES = "races"  # folder of the scenario files of races, beside their results


class Runs:
    """Runs races and scenarios whose results go to one folder."""

    def __init__(self, results: Optional[Path] = None, planner: Optional[str] = None):
        """`results`: default as of the command; `planner` drives where a call names none."""
        extensions(GROUP)  # with ROS, packages are found where ROS finds them
        self._given = results
        self._planner = planner

    @property
    def _results(self) -> Path:
        return (self._given or lookup.results_root()).resolve()

    def race(
        self,
        place: str,
        planner: "str | Sequence[str] | None" = None,
        laps: int = 1,
        seed: Optional[int] = None,
        *,
        arguments: Mapping[str, str] = {},  # noqa: B006
        interface: str = "native",
        settings: Sequence[str] = (),
        name: Optional[str] = None,
    ) -> Run:
        """Race some laps of a place, as `f1tenth race` does, and wait for the verdict.

        Args:
            place: name of a circuit or world, or the path of a .world file or of the YAML file of a map
            planner: `FILE.py:CLASS`, a launch file, or one of ours; several race each other. Paths are
                relative to the working directory
            laps: after which the race is over
            seed: of all noise
            arguments: for the planner
            interface: topics that a launch file knows, `native` or `f1tenth`
            settings: KEY=VALUE, as of `--set`
            name: of the results' folder; default: race_PLACE

        Raises:
            NotApplicableError: it needs ROS 1, which is not installed.
            ScenarioError: what is named is not there, or the run left no result.
        """
        drivers = self._drivers(planner, interface, arguments)
        wanted = Race(place, laps, drivers, called=name)
        changes = [*settings, *_seed(seed)]
        require_runner(plan_race(wanted, self._results / wanted.name, changes))
        file = self._results / _RACES / f"{wanted.name}.yaml"
        with writing(file):
            file.parent.mkdir(parents=True, exist_ok=True)
        save_race(wanted, file)
        return self._run(Job(str(file), tuple(changes), str(self._results)))

    def run(
        self,
        scenario: str,
        planner: Optional[str] = None,
        seed: Optional[int] = None,
        *,
        settings: Sequence[str] = (),
        name: Optional[str] = None,
    ) -> Run:
        """Run a scenario, as `f1tenth run` does; arguments as of `race`.

        Raises:
            NotApplicableError: it says nothing about this planner, or needs ROS 1, which is not installed.
            ScenarioError: what is named is not there, or the run left no result.
        """
        planner = planner or self._planner
        drivers = [planner_setting(named_planner(planner, Path.cwd()))] if planner else []
        changes = [*settings, *_seed(seed), *drivers]
        plan = make_plan(scenario, settings=changes)
        require_runner(plan)
        return self._run(Job(str(plan.file), tuple(changes), str(self._results), name=name or plan.name))

    def _drivers(self, planner, interface: str, arguments: Mapping[str, str]) -> Sequence[Driver]:
        names = [planner] if isinstance(planner, str) else planner or [self._planner or "race"]
        return [named_planner(each, Path.cwd(), Interface(interface), arguments) for each in names]

    def _run(self, job: Job) -> Run:
        outcome = run_job(job)
        if outcome.result is None:
            raise ScenarioError(outcome.problem)
        return Run(job.folder, outcome.result, next(iter(outcome.result["cars"])))


def _seed(seed: Optional[int]) -> list[str]:
    return [] if seed is None else [f"seed={seed}"]
