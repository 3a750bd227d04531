"""What a person or a script reads about a run."""

import statistics
import sys
import textwrap
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Optional, TextIO

from f1tenth_judge.judge.criterion import Status
from f1tenth_judge.judge.driving_criteria import least_clearance
from f1tenth_judge.plan.hand_off import offered_arguments
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.files import PICTURE_FILE, RESULT_FILE
from f1tenth_judge.record.pace import Pace
from f1tenth_judge.results.moment import replay_of
from f1tenth_judge.results.reference_laps import reference_of
from f1tenth_judge.results.result import Result
from f1tenth_judge.results.results_folder import INTERRUPTED_FOLDER
from f1tenth_judge.results.standing import name_of

_REDRAW_INTERVAL = 0.2  # wall s
_LINE_WIDTH = 200  # characters, of a log's lines


class _Line:
    """One line that is drawn over and over; nothing where the output is no terminal."""

    def __init__(self, name: str, stream: Optional[TextIO]):
        self._name, self._stream = name, stream or sys.stderr

    def clear(self) -> None:
        """Leave an empty line."""
        self._draw("")

    def _draw(self, text: str) -> None:
        if self._stream.isatty():
            self._stream.write(f"\r\033[K{text}")
            self._stream.flush()


class ProgressLine(_Line):
    """How far a run is."""

    def __init__(self, name: str, stream: Optional[TextIO] = None):
        super().__init__(name, stream)
        self._next = 0.0
        self._pace = Pace()

    def update(self, simulated: Optional[float], wall: float) -> None:
        """Show how far the run is: simulated and wall time, s."""
        self._pace.note(simulated, wall)
        if time.monotonic() >= self._next:
            self._next = time.monotonic() + _REDRAW_INTERVAL
            self._draw(f"{self._name}  {self._text(simulated, wall)}")

    def _text(self, simulated, wall):
        if simulated is None:
            return f"starting  {wall:.0f} s"
        factor = f"  {self._pace.factor:.1f}x real time" if self._pace.factor else ""
        return f"{simulated:.1f} s simulated{factor}"


class CountLine(_Line):
    """How many runs are done; where the output is no terminal, a line of text after each tenth of them."""

    _WIDTH = 30  # characters
    _TENTHS = 10

    def __init__(self, name: str, count: int, stream: Optional[TextIO] = None, each_is_told: bool = False):
        """With `each_is_told` each run has a line of its own already."""
        super().__init__(name, stream)
        self._count, self._each_is_told = count, each_is_told
        self._done = self._passed = 0

    def update(self, passed: bool) -> None:
        """One more run is done."""
        self._done += 1
        self._passed += passed
        filled = self._WIDTH * self._done // self._count
        bar = "█" * filled + "░" * (self._WIDTH - filled)
        text = f"{self._done} of {self._count}, {self._passed} passed"
        self._draw(f"{self._name}  {bar}  {text}")
        is_tenth = self._TENTHS * self._done % self._count < self._TENTHS
        if is_tenth and not self._each_is_told and not self._stream.isatty():
            print(f"{self._name}  {text}", file=self._stream, flush=True)


def summary(result: Result, plan: Plan) -> str:
    """The outcome in lines of `name: value`, for a person and for grep."""
    decision = result.judgement.decision
    lines = [
        ("scenario", result.name),
        ("verdict", f"{decision.verdict.value} (expected {plan.scenario.expected.value})"),
        ("passed", "yes" if result.passed else "no"),
        ("reason", result.reason),
        *([("note", result.note)] if result.note else []),
        *_drivers(plan),
        *_winner(result),
        *_arguments(plan),
        ("lap time", _unit(result.best_lap_time, "s", 3)),
        *_reference(result, plan),
        *_all_laps(result, plan),
        ("minimum clearance", _unit(least_clearance(result.judgement), "m", 3)),
        ("real-time factor", _unit(result.measured.real_time_factor, "", 1)),
        ("cost", f"{_unit(result.cost, 's', 1)} besides simulating"),
        *_failed_criteria(result),
        *_limits_of_reference(result),
        *_culprit_log(result),
        ("result", str(result.folder / RESULT_FILE)),
        *_picture(result),
        *_replay(result),
        *(("not written", problem) for problem in result.not_written),
    ]
    return "\n".join(f"{name + ':' if name else '':19}{value}" for name, value in lines)


def cost_of_all(costs: Mapping[str, float]) -> str:
    """What scenarios cost besides simulating (wall s, by name), in a line."""
    dearest = max(costs, key=costs.__getitem__)
    return (
        f"cost besides simulating: median {statistics.median(costs.values()):.1f} s,"
        f" at most {costs[dearest]:.1f} s ({dearest})"
    )


def _arguments(plan):
    """What others' planners get in place of their own defaults, which may not mean the same."""
    for car in plan.scenario.cars:
        file = plan.cars[car.name].driver
        own = file.arguments - file.required - car.driver.arguments.keys()
        told = {name: value for name, value in offered_arguments(plan, car).items() if name in own}
        if told and not car.driver.is_ours:
            texts = (
                f"{name}={value.name if isinstance(value, Path) else value}"
                for name, value in sorted(told.items())
            )
            yield "arguments", f"of {car.name} by the scenario: {', '.join(texts)}"


def _reference(result, plan):
    reference = reference_of(plan)
    if reference and result.best_lap_time:
        times = result.best_lap_time / reference.time
        several = plan.scenario.laps > 1 or any(task.laps > 1 for task in plan.tasks.values())
        lap = "the best lap" if several else "this lap, from standstill,"
        yield "reference", f"{reference.time:.3f} s ({reference.what}); {lap} took {times:.2f} times as long"


def _all_laps(result, plan):
    racing = {name: car.task for name, car in plan.cars.items() if not car.task.is_empty}
    if plan.scenario.laps > 1 or len(racing) > 1 or any(task.laps > 1 for task in racing.values()):
        for car in racing:
            times = ", ".join(_unit(time, "s", 3) for time in result.lap_times(car))
            yield f"laps of {car}", times or "none"


def _drivers(plan):
    cars = plan.scenario.cars
    for car in cars:
        whose = f" of {car.name}" if len(cars) > 1 else ""
        yield f"driver{whose}", f"{car.driver.name} ({car.driver.kind})"


def _winner(result):
    if won := result.winner:
        names = {car.name: name_of(car) for car in result.scenario.cars}
        behind = "did not finish" if won.ahead is None else f"{_unit(won.ahead, 's', 3)} later"
        yield "winner", f"{names[won.car]}; {names[won.second]} {behind}"


def _picture(result):
    # What was not written is told with the reason.
    if not any(problem.startswith(f"{PICTURE_FILE}:") for problem in result.not_written):
        yield "picture", str(result.folder / PICTURE_FILE)


def _replay(result):
    if not result.passed and result.folder.name != INTERRUPTED_FOLDER:  # which no report shows
        yield "replay", f"{replay_of(result)} (of the page that --report or `f1tenth report` writes)"


def _failed_criteria(result):
    for criterion in result.criteria:
        if criterion.status is Status.FAILED:
            yield "failed", f"{criterion.name}: {criterion.comparison}"


def _limits_of_reference(result):
    for criterion in result.criteria:
        if criterion.name in result.scenario.limits_of_reference:
            yield "of the reference", f"{criterion.name}: {criterion.comparison}; not judged"


def _culprit_log(result):
    failure = result.judgement.failure
    if failure and failure.log_file:
        yield "log", failure.log_file
        yield from (("", textwrap.shorten(line, _LINE_WIDTH)) for line in failure.log_lines)


def _unit(value, unit, digits):
    return "none" if value is None else f"{value:.{digits}f} {unit}".rstrip()
