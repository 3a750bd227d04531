"""Many variations of a scenario: `f1tenth sweep` and `f1tenth suite`."""

import dataclasses
import itertools
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.batch.cluster import run_on_cluster
from f1tenth_judge.batch.inputs import hash_inputs, hash_software
from f1tenth_judge.batch.jobs import Job, Outcome, read_result, run_jobs
from f1tenth_judge.batch.repeat import difference
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.results.console import CountLine
from f1tenth_judge.run.ros import require_runner
from f1tenth_judge.scenario.settings import Setting, folder_name, parse_variation
from f1tenth_judge.stop_request import StopRequest

_INPUTS_FILE = "inputs.sha256"  # beside a result: what it depends on


Cases = Mapping[str, Sequence[Setting]]  # values by the name of a case, which is also that of its folder
_OUR_PROCESSES = ("runner", "sim2d")  # culprits that are not planners


@dataclasses.dataclass(frozen=True)
class Case:
    """One run of a sweep."""

    scenario: str  # its name, or its file
    settings: Sequence[Setting] = ()


def combinations(variations: Sequence[str]) -> Cases:
    """Every combination of values; `variations`: KEY=VALUES, as `parse_variation` reads them.

    Raises:
        ScenarioError: a key is varied twice, or combinations could not be told apart in folders' names.
    """
    varied = [parse_variation(text) for text in variations]
    keys = [values[0].key for values in varied]
    for key in keys:
        if keys.count(key) > 1:
            raise ScenarioError(f"--vary {key}: is varied more than once")
    found: dict[str, Sequence[Setting]] = {}
    for each in itertools.product(*varied):
        other = found.setdefault(folder_name(each), each)
        # Values that differ only in characters that no folder's name can have would overwrite each other.
        if other is not each:
            values = (" ".join(map(str, settings)) for settings in (other, each))
            raise ScenarioError(
                "'{}' and '{}' would both be written to {}".format(*values, folder_name(each))
            )
    return found


class Sweep:
    """A scenario with several sets of values."""

    def __init__(
        self,
        cases: Mapping[str, Case],
        folder: Path,
        settings: Sequence[str] = (),
        bag: bool = False,
        repeat: Optional[int] = None,
    ):
        """Check everything; nothing is run yet.

        Args:
            cases: what is run, by the names of the cases
            folder: for the folders of the cases, which have their names
            settings: KEY=VALUE, the same in all runs
            bag: keep the bags of all runs
            repeat: how often each case is run; the first run counts, the others tell whether it is repeatable

        Raises:
            NotApplicableError: the scenario says nothing about a planner that the settings name.
            ScenarioError: bad input.
        """
        self.keys = [setting.key for setting in next(iter(cases.values())).settings]
        self._name = folder.name
        self._software = hash_software()
        self._inputs: dict[Job, str] = {}
        self._again: dict[Job, list[Job]] = {}
        self.plans: dict[Job, Plan] = {}
        for name, case in cases.items():
            texts = (*settings, *map(str, case.settings))
            plan = make_plan(case.scenario, settings=texts)
            require_runner(plan)
            job = Job(str(plan.file), texts, str(folder), ("--bag",) if bag else (), name=name)
            numbers = range(2, (repeat or 1) + 1)
            again = [dataclasses.replace(job, name=f"{name},repeat={number}") for number in numbers]
            self._inputs |= dict.fromkeys([job, *again], hash_inputs(plan, self._software))
            self.plans[job] = plan
            self._again[job] = again
        self.reused: list[Job] = []
        self.results: dict[Job, dict[str, Any]] = {}
        self.problems: list[str] = []
        self.unsteady: list[Job] = []  # whose repeated runs differ

    @property
    def jobs(self) -> list[Job]:
        """In the order of the values, those of a case together."""
        return list(self._inputs)

    def run(self, stop: StopRequest, at_once: Optional[int] = None, scheduler: Optional[str] = None) -> None:
        """Run all jobs except those that have a result of the same inputs.

        Args:
            stop: tells it to end
            at_once: local processes; default: one per core
            scheduler: address of a Dask scheduler to use instead

        Raises:
            ScenarioError: the scheduler cannot be reached, or an earlier result cannot be replaced.
        """
        self.results = {job: old for job in self.jobs if (old := self._old_result(job))}
        self.reused = list(self.results)
        left = [job for job in self.jobs if job not in self.results]
        # What is noted of an earlier result must not hold for the one that takes its place.
        for file in (job.folder / _INPUTS_FILE for job in left):
            with writing(file):
                file.unlink(missing_ok=True)
        bar = CountLine(self._name, len(self.jobs))
        for result in self.results.values():
            bar.update(result["passed"])
        if scheduler and left:
            outcomes = run_on_cluster(left, stop, scheduler)
        else:
            outcomes = run_jobs(left, stop, at_once or os.cpu_count() or 1)
        for outcome in outcomes:
            self._take(outcome)
            bar.update(outcome.exit_code == 0)
        bar.clear()
        for job, again in self._again.items():
            if differs := difference([self.results[each] for each in (job, *again) if each in self.results]):
                self.unsteady.append(job)
                self.problems.append(f"{job.folder}: not repeatable: {differs}")

    def rows(self) -> Iterator[dict[str, Any]]:
        """A row of the table for each case that has a result."""
        return (row for _, row in self.rows_of_jobs())

    def rows_of_jobs(self) -> Iterator[tuple[Job, dict[str, Any]]]:
        """The same with their jobs."""
        for job in self.plans:
            if job in self.results:
                result = self.results[job]
                yield (
                    job,
                    {
                        **{key: dict(each.split("=", 1) for each in job.settings)[key] for key in self.keys},
                        "verdict": result["verdict"],
                        "passed": result["passed"],
                        "lap_time": result["times"]["lap_time"],
                        "minimum_clearance": result["minimum_clearance"],
                        "trajectory_hash": result["trajectory_hash"],
                        "reason": result["reason"],
                    },
                )

    def _old_result(self, job: Job) -> Optional[dict[str, Any]]:
        try:
            is_same = (job.folder / _INPUTS_FILE).read_text(encoding="utf-8") == self._inputs[job]
        except OSError:
            return None
        return read_result(job.folder) if is_same else None

    def _take(self, outcome: Outcome) -> None:
        job = outcome.job
        if outcome.result is None:
            self.problems.append(outcome.problem)
            return
        if _broke_down(outcome.result):
            self.problems.append(f"{job.folder}: not counted: {outcome.result['reason']}")
            return
        self.results[job] = outcome.result
        # If something was changed during a run, nobody knows what it depends on.
        if hash_software() != self._software:
            return
        file = job.folder / _INPUTS_FILE
        try:
            with writing(file):
                file.write_text(self._inputs[job], encoding="utf-8")
        except ScenarioError as error:
            self.problems.append(str(error))


def _broke_down(result: Mapping[str, Any]) -> bool:
    """Whether a run says nothing about its planner: what runs it was hung, killed or told to stop."""
    return result["verdict"] == "error" and (result["culprit"] or {}).get("culprit") in _OUR_PROCESSES
