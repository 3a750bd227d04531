"""The verdict: what ended the run, and when.

Everything after the deciding stamp is cut: a run gives the same result however late its end was noticed.
"""

import dataclasses
import functools
from collections.abc import Iterator, Mapping, Sequence
from typing import Optional

from f1tenth_judge.judge.contacts import find_contacts
from f1tenth_judge.judge.false_start import find_false_start, moves_of
from f1tenth_judge.judge.goal_passes import GoalPasses, find_passes
from f1tenth_judge.judge.interventions import driver_behind, forbidden
from f1tenth_judge.judge.jumps import find_jumps
from f1tenth_judge.judge.progress import finish_of, how_far
from f1tenth_judge.plan.task import Task
from f1tenth_judge.record.interventions import Intervention
from f1tenth_judge.record.observations import Failure, Observations, RaceState, RaceUpdate
from f1tenth_judge.record.record import STAMP_EPSILON, Contact, Record
from f1tenth_judge.scenario.criteria import Criteria
from f1tenth_judge.scenario.scenario import Scenario, Verdict

Tasks = Mapping[str, Task]


@dataclasses.dataclass(frozen=True)
class Decision:
    """How and when a run ended."""

    stamp: float  # s, simulated
    verdict: Verdict
    reason: str


@dataclasses.dataclass(frozen=True)
class Judgement:
    """A decision and what it rests on, nothing later than its stamp."""

    decision: Decision
    record: Record
    passes: dict[str, GoalPasses]
    failure: Optional[Failure] = None
    interventions: tuple[Intervention, ...] = ()

    @functools.cached_property
    def contacts(self) -> list[Contact]:
        """Every contact up to the decision, once."""
        return find_contacts(self.record)


# Of what happens at the same stamp the more serious counts.
_RANK = (
    Verdict.COLLISION,
    Verdict.DISQUALIFIED,
    Verdict.ABORTED,
    Verdict.SUCCESS,
    Verdict.TIMEOUT,
    Verdict.ERROR,
)


def judge(scenario: Scenario, tasks: Tasks, seen: Observations) -> Judgement:
    """Judge a run; `tasks` by car."""
    jumps = find_jumps(seen.record, seen.interventions)
    done = sorted((*seen.interventions, *jumps), key=lambda each: each.stamp)
    seen = dataclasses.replace(seen, interventions=tuple(done))
    endings = list(_endings(scenario, tasks, seen)) or [_undecided(seen)]
    decision = min(endings, key=lambda ending: (ending.stamp, _RANK.index(ending.verdict)))
    record = seen.record.until(decision.stamp)
    # Outside lockstep a car may reach its goal between two periods.
    driven = seen.record.covering(decision.stamp)
    passes = {car: _passes(scenario, driven, car, task.goals) for car, task in tasks.items() if task.goals}
    if decision.verdict is Verdict.SUCCESS:
        decision = _verify_success(decision, seen.record, passes)
    failure = seen.failure if decision.verdict is Verdict.ERROR else None
    interventions = tuple(each for each in seen.interventions if each.stamp <= decision.stamp + STAMP_EPSILON)
    return Judgement(decision, record, passes, failure, interventions)


def broken(judgement: Judgement, failure: Failure) -> Judgement:
    """The same, when what was judged cannot be: the set-up is wrong."""
    reason = f"{failure.culprit}: {failure.reason}"
    decision = dataclasses.replace(judgement.decision, verdict=Verdict.ERROR, reason=reason)
    return dataclasses.replace(judgement, decision=decision, failure=failure)


def is_decided(tasks: Tasks, updates: Sequence[RaceUpdate], finishes: Mapping[str, Optional[float]]) -> bool:
    """Whether it is over: every task done, or a car gave up.

    `finishes`: when the record shows the task of a car to be done (s), so far.
    """
    return any(True for _ in (*_tasks_done(tasks, updates, finishes), *_races_aborted(updates)))


def _endings(scenario: Scenario, tasks: Tasks, seen: Observations) -> Iterator[Decision]:
    yield from (each for each in _shown(scenario, tasks, seen) if _is_sound(each, seen))
    yield from _races_aborted(seen.updates)
    yield from _breakdowns(seen)


def _shown(scenario: Scenario, tasks: Tasks, seen: Observations) -> Iterator[Decision]:
    """How the record lets the run end."""
    yield from _collisions(scenario, seen)
    yield from _disqualifications(scenario, seen)
    yield from _false_starts(scenario, tasks, seen)
    yield from _tasks_done(tasks, seen.updates, finishes(scenario.criteria, tasks, seen.record))
    yield from _timeouts(scenario, tasks, seen)


def _is_sound(decision: Decision, seen: Observations) -> bool:
    """Whether it was decided before the set-up broke."""
    return seen.sound_until is None or decision.stamp <= seen.sound_until + STAMP_EPSILON


def finishes(criteria: Criteria, tasks: Tasks, record: Record) -> dict[str, Optional[float]]:
    """When the record shows the task of each of its cars to be done, s; nothing where it does not."""
    return {
        car: finish_of(record.tracks[car], task, criteria)
        for car, task in tasks.items()
        if car in record.tracks
    }


def first_collision(scenario: Scenario, record: Record) -> Optional[Contact]:
    """The first contact that is no light touch; nothing without one."""
    return next((each for each in find_contacts(record) if each.speed >= scenario.criteria.light_touch), None)


def _collisions(scenario, seen):
    contact = first_collision(scenario, seen.record)
    if contact:
        touched = " and ".join(contact.touched)
        reason = f"{contact.car} touched {touched} at {contact.start:.3f} s with {contact.speed:.2f} m/s"
        yield Decision(contact.start, Verdict.COLLISION, reason)


def _disqualifications(scenario, seen):
    for each in forbidden(scenario, seen.interventions):
        car = driver_behind(scenario, each)
        who = f"{car} is out: " if car else ""
        yield Decision(
            each.stamp, Verdict.DISQUALIFIED, f"{who}{each.describe()}, which the scenario does not allow"
        )


def _false_starts(scenario, tasks, seen):
    found = find_false_start(scenario, tasks, moves_of(seen.record), seen.updates)
    if found:
        stamp, reason = found
        yield Decision(stamp, Verdict.ABORTED, reason)


def _races_aborted(updates):
    for update in updates:
        if update.state is RaceState.ABORTED:
            reason = f"{update.car} gave up at {update.stamp:.3f} s: {update.reason or 'no reason given'}"
            yield Decision(update.stamp, Verdict.ABORTED, reason)


def _tasks_done(tasks, updates, finishes):
    stamps = [_finish(task, updates, car, finishes) for car, task in tasks.items() if not task.is_empty]
    if stamps and None not in stamps:
        yield Decision(max(stamps), Verdict.SUCCESS, _what_was_done(tasks))


def _finish(task, updates, car, finishes):
    """When a car was done with its task, s: by the record.

    One that says itself when it has reached its goals is not done before it says so.
    """
    own = [update for update in updates if update.car == car]
    if task.laps or not (own or task.reports):
        return finishes.get(car)
    return next((update.stamp for update in own if _says_done(update, len(task.goals))), None)


def _says_done(update, goal_count) -> bool:
    # In loop mode race_mgr never says that it has finished.
    return update.state is RaceState.FINISHED or update.goals_reached >= goal_count


def _what_was_done(tasks) -> str:
    todo = [task for task in tasks.values() if not task.is_empty]
    several = len(todo) > 1
    if all(task.laps for task in todo):
        return "every car drove its laps" if several else "every lap was driven"
    return "every car passed every goal in order" if several else "every goal was passed in order"


def _timeouts(scenario, tasks, seen):
    end, timeout = seen.record.end, scenario.limits.timeout
    if end is not None and end + STAMP_EPSILON >= timeout:
        tracks = seen.record.until(timeout).tracks
        racing = {car: task for car, task in tasks.items() if car in tracks and not task.is_empty}
        got = [how_far(tracks[car], task, scenario.criteria) for car, task in racing.items()]
        reason = "; ".join([f"not finished after {timeout:g} s of simulated time", *got])
        yield Decision(timeout, Verdict.TIMEOUT, reason)


def _breakdowns(seen):
    failure = seen.failure
    if failure:
        stamp = _end(seen.record) if failure.stamp is None else failure.stamp
        yield Decision(stamp, Verdict.ERROR, f"{failure.culprit}: {failure.reason}")


def _undecided(seen):
    return Decision(_end(seen.record), Verdict.ERROR, "runner: the run ended without a decision")


def _end(record: Record) -> float:
    return 0.0 if record.end is None else record.end


def _passes(scenario, record, car, poses):
    criteria = scenario.criteria
    limits = criteria.goal_tolerance, criteria.goal_yaw_tolerance
    track = record.tracks.get(car)
    return find_passes(track, poses, *limits) if track else GoalPasses(poses, *limits)


def _verify_success(decision: Decision, record: Record, passes: Mapping[str, GoalPasses]) -> Decision:
    """A planner may say that it is there; the record must say so too."""
    end = _end(record)
    if end + STAMP_EPSILON < decision.stamp:
        reason = f"its record ends before the race does ({end:.3f} s instead of {decision.stamp:.3f} s)"
        return Decision(end, Verdict.ERROR, f"sim2d: {reason}")
    for car, result in passes.items():
        if not result.complete:
            where = f", nearest {result.nearest:.2f} m" if result.nearest is not None else ""
            reason = (
                f"{car} says that it finished, but did not pass goal {len(result.times) + 1} of"
                f" {result.wanted} in order{where}"
            )
            return Decision(decision.stamp, Verdict.ABORTED, reason)
    return decision
