"""One trial: a car drives, and amcl is told something about where it is."""

import dataclasses
import enum
import math
import random
from collections.abc import Iterator, Sequence
from itertools import takewhile
from typing import Any

import numpy as np
from f1tenth_gazebo.errors import MapError
from f1tenth_gazebo.maps.map_file import load_map
from f1tenth_gazebo.poses import Pose
from f1tenth_scenarios.errors import ScenarioError

import f1tenth_sim2d
from f1tenth_scenarios import places
from f1tenth_studies.drives.drive import Drive, Journey, Sample
from f1tenth_studies.drives.rms import rms
from f1tenth_studies.lost.alike import View, is_alike
from f1tenth_studies.lost.localizer import localizer_module, make_localizer
from f1tenth_studies.optimum.track import load_track

NEAR, ALIGNED = 0.3, 0.15
"""m and rad; a car that is believed to be no farther off is found."""
AFTERWARDS = 5.0
"""s, for which it must stay found."""
_SCANS_PER_VIEW = 20
_BEND, _BEND_WITHIN = 0.5, 6.0  # rad, m


class Told(enum.Enum):
    """What amcl is told at the start: how far off that is (m, rad), and how certain it is said to be."""

    TRUTH = "the truth", 0.0, 0.0
    NEAR = "0.5 m and 20 deg beside it", 0.5, math.radians(20.0)
    FAR = "2 m and 30 deg beside it", 2.0, math.radians(30.0)
    NOTHING = "nothing", math.inf, math.inf

    def __init__(self, words: str, distance: float, turn: float):
        self.words, self.distance, self.turn = words, distance, turn

    @property
    def is_wrong(self) -> bool:
        """Whether it is a place, but not where the car is."""
        return 0.0 < self.distance < math.inf


@dataclasses.dataclass(frozen=True)
class Trial:
    """A drive, what amcl is told before it, and how soon it has to know better."""

    drive: Drive
    told: Told
    limit: float  # s; when told the truth, of the whole drive


@dataclasses.dataclass(frozen=True)
class Found:
    """The outcome of a trial."""

    trial: Trial
    after: float  # s, since when the car was where it was believed to be; infinite: not at the end
    errors: np.ndarray  # (n,), m, at the scans since
    deviations: np.ndarray  # (n,), m, as amcl reports them
    alike: bool = False  # whether, until the limit, walls looked the same where it was last believed wrongly

    @property
    def in_time(self) -> bool:
        """Whether the car was found in time; if told the truth, whether amcl always knew, and how well."""
        if self.trial.told is Told.TRUTH:
            return self.after == 0.0 and rms(self.deviations) >= rms(self.errors) / 2
        return self.after <= self.trial.limit

    @property
    def passed(self) -> bool:
        """Whether it was found in time, or nothing could tell where it was."""
        return self.in_time or self.alike


def make_trial(drive: Drive, told: Told, limit: float) -> Trial:
    """The trial of a drive that begins anywhere on its road; before a bend if amcl is told something wrong.

    Raises:
        ScenarioError: the centreline cannot be read.
    """
    generator = random.Random(f"{drive.place} {told.name} {drive.seed}")
    begins = _before_bends(load_track(drive.centreline)[:, :2]) if told.is_wrong else ()
    begin = generator.choice(begins) if len(begins) else generator.random()
    return Trial(dataclasses.replace(drive, begin=float(begin)), told, limit)


def find(trial: Trial) -> Found:
    """Drive, and tell how soon amcl knew where the car was.

    Raises:
        ScenarioError: a file is wrong, or amcl is the original.
    """
    amcl = localizer_module()
    try:
        return _find(trial, amcl)
    except (f1tenth_sim2d.Error, amcl.Error, MapError, OSError) as error:
        raise ScenarioError(f"{trial.drive.place}, seed {trial.drive.seed}: {error}") from error


def _find(trial: Trial, amcl: Any) -> Found:
    journey = Journey(trial.drive)
    localizer = _localizer(amcl, trial)
    end = trial.limit + (0.0 if trial.told is Told.TRUTH else AFTERWARDS)
    beliefs, views = [], []
    for sample in _until(end, journey):
        localizer.process(sample.ranges, *journey.geometry, journey.mount, sample.odometry)
        pose, covariance = localizer.estimate()
        if len(beliefs) % _SCANS_PER_VIEW == 0 and sample.time <= trial.limit:
            views.append(View(journey.points(sample.ranges), sample.truth))
        deviation = math.sqrt(covariance[0, 0] + covariance[1, 1])
        beliefs.append(_Belief(sample.time, sample.truth, pose, deviation))
    since = max((i + 1 for i, belief in enumerate(beliefs) if belief.is_wrong), default=0)
    after = beliefs[since].time if since < len(beliefs) else math.inf
    errors = np.array([belief.difference[0] for belief in beliefs[since:]])
    deviations = np.array([belief.deviation for belief in beliefs[since:]])
    alike = after > trial.limit and _is_alike(trial, views, beliefs[:since])
    return Found(trial, after, errors, deviations, alike)


def _is_alike(trial: Trial, views: Sequence[View], beliefs: Sequence["_Belief"]) -> bool:
    wrong = [belief for belief in beliefs if belief.is_wrong]
    last = next((belief for belief in reversed(wrong) if belief.time <= trial.limit), wrong[-1])
    return is_alike(load_map(places.map_file(trial.drive.world)), views, last.truth, last.pose)


def _until(end: float, journey: Journey) -> Iterator[Sample]:
    return takewhile(lambda sample: sample.time <= end, journey.samples())


def _localizer(amcl: Any, trial: Trial) -> Any:
    drive, told = trial.drive, trial.told
    believed, deviations = drive.start, None
    if told.is_wrong:
        believed = _beside(believed, told, random.Random(drive.seed))
        deviations = told.distance, told.distance, told.turn
    localizer = make_localizer(amcl, drive, believed, deviations)
    if told is Told.NOTHING:
        localizer.spread_out()
    return localizer


def _beside(pose: Pose, told: Told, generator: random.Random) -> Pose:
    direction = generator.uniform(-math.pi, math.pi)
    return (
        pose[0] + told.distance * math.cos(direction),
        pose[1] + told.distance * math.sin(direction),
        pose[2] + generator.choice((-1.0, 1.0)) * told.turn,
    )


@dataclasses.dataclass(frozen=True)
class _Belief:
    """Where amcl believes the car to be."""

    time: float  # s
    truth: Pose
    pose: Pose
    deviation: float  # m

    @property
    def difference(self) -> tuple[float, float]:
        """From the truth: distance (m) and turn (rad)."""
        turn = math.remainder(self.pose[2] - self.truth[2], math.tau)
        return math.hypot(self.pose[0] - self.truth[0], self.pose[1] - self.truth[1]), abs(turn)

    @property
    def is_wrong(self) -> bool:
        distance, turn = self.difference
        return distance > NEAR or turn > ALIGNED


def _before_bends(track: np.ndarray) -> np.ndarray:
    """At which parts of a closed line, (n, 2) in m, a bend begins within the next metres."""
    steps = np.roll(track, -1, axis=0) - track
    ahead = max(1, round(_BEND_WITHIN / float(np.hypot(*steps.T).mean())))
    heading = np.arctan2(steps[:, 1], steps[:, 0])
    turns = np.abs(np.remainder(np.roll(heading, -ahead) - heading + math.pi, math.tau) - math.pi)
    return np.flatnonzero(turns >= _BEND) / len(track)
