"""What a replay shows besides trajectories, as walls, models, lidars and plans; kept as replay.json.gz."""

import dataclasses
import gzip
import json
import zlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from f1tenth_judge.atomic import replacing
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.record import STAMP_EPSILON

if TYPE_CHECKING:  # the scenarios' code needs ROS, which may be missing where episodes are recorded
    from f1tenth_judge.scenario.car import Pose

_FORMAT = 2

Point = tuple[float, float]  # m
Planar = tuple[float, float, float]  # m, m, rad
# Angles of the first and the last beam (rad), place in base_footprint (m, m, rad), range (m).
Lidar = tuple[float, float, float, float, float, float]
# Rear, front, right and left end in base_footprint, wheelbase, track; all m.
Body = tuple[float, float, float, float, float, float]

T = TypeVar("T", bound="Timed")


@dataclasses.dataclass(frozen=True)
class Shape:
    """A horizontal cut through something solid."""

    outlines: Sequence[Sequence[Point]] = ()  # closed
    circles: Sequence[Planar] = ()  # x, y, radius; m


@dataclasses.dataclass(frozen=True)
class Timed:
    """Things with the stamp (s) from which each of them holds; lists of equal length."""

    stamps: Sequence[float] = ()
    values: Sequence[Any] = ()

    def until(self: T, stamp: float) -> T:
        """Those up to and including a stamp (s)."""
        count = sum(each <= stamp + STAMP_EPSILON for each in self.stamps)
        return dataclasses.replace(self, stamps=self.stamps[:count], values=self.values[:count])


@dataclasses.dataclass(frozen=True)
class Poses(Timed):
    """Where a movable model was, with its shape in its own frame."""

    shape: Shape = Shape()


@dataclasses.dataclass(frozen=True)
class Drawing:
    """What a planner draws on the ground, in the map frame."""

    colour: str = ""  # #rrggbb; empty: none is asked for
    lines: Sequence[Sequence[Point]] = ()
    dots: Sequence[Planar] = ()  # x, y, radius; m
    texts: Sequence[tuple[float, float, str]] = ()


@dataclasses.dataclass(frozen=True)
class Numbers(Timed):
    """What a planner of a car published as numbers."""

    car: str = ""


@dataclasses.dataclass(frozen=True)
class Replay:
    """What the replay of a run shows besides its trajectories."""

    walls: Shape = Shape()
    goals: Mapping[str, Sequence[Planar]] = dataclasses.field(default_factory=dict)  # by car, of one lap
    road: Sequence[Point] = ()  # its middle, closed, in driving order
    lidars: Mapping[str, Lidar] = dataclasses.field(default_factory=dict)  # by car
    bodies: Mapping[str, Body] = dataclasses.field(default_factory=dict)  # by car
    # By car, plans: lists of points in the map frame, m.
    global_plans: Mapping[str, Timed] = dataclasses.field(default_factory=dict)
    local_plans: Mapping[str, Timed] = dataclasses.field(default_factory=dict)
    models: Mapping[str, Poses] = dataclasses.field(default_factory=dict)  # by name
    # By topic, of planners: lists of Drawing, and numbers.
    drawings: Mapping[str, Timed] = dataclasses.field(default_factory=dict)
    channels: Mapping[str, Numbers] = dataclasses.field(default_factory=dict)
    # By topic, what planners saw: small JPEG images, in base64.
    pictures: Mapping[str, Timed] = dataclasses.field(default_factory=dict)

    def with_run(
        self, goals: Mapping[str, Sequence["Pose"]], said: "Replay", road: Sequence[Point] = ()
    ) -> "Replay":
        """This scene with a run in it; `said` has what planners published, and where models were."""
        return dataclasses.replace(
            said,
            walls=self.walls,
            goals={car: [(pose.x, pose.y, pose.yaw) for pose in poses] for car, poses in goals.items()},
            road=road,
            lidars=self.lidars,
            bodies=self.bodies,
            models={
                name: dataclasses.replace(said.models.get(name, model), shape=model.shape)
                for name, model in self.models.items()
            },
        )

    def until(self, stamp: float) -> "Replay":
        """What holds up to and including a stamp (s)."""
        timed: dict = {
            field.name: {name: each.until(stamp) for name, each in getattr(self, field.name).items()}
            for field in dataclasses.fields(self)
            if field.name in ("global_plans", "local_plans", "models", "drawings", "channels", "pictures")
        }
        return dataclasses.replace(self, **timed)


def write_replay(path: Path, replay: Replay) -> None:
    """Write the file, which replaces the old one when complete; the same replay gives the same bytes."""
    # Not dataclasses.asdict, which copies every number and takes four times as long as all the rest.
    text = json.dumps({"format": _FORMAT, **vars(replay)}, default=vars, separators=(",", ":"))
    with replacing(path) as temporary:
        temporary.write_bytes(gzip.compress(text.encode(), compresslevel=6, mtime=0))


def read_replay(path: Path) -> Replay:
    """Read the file; an empty replay where there is none.

    Raises:
        ScenarioError: the file is broken, or of another version.
    """
    try:
        content = json.loads(gzip.decompress(path.read_bytes()), parse_constant=_refuse)
    except FileNotFoundError:
        return Replay()
    except (OSError, EOFError, ValueError, zlib.error) as error:
        raise ScenarioError(f"{path}: not a replay: {error}") from error
    if not isinstance(content, dict) or content.get("format") != _FORMAT:
        raise ScenarioError(f"{path}: not a replay of format {_FORMAT}; run the scenario again")
    try:
        return _from_dict(content)
    except KeyError as error:
        raise ScenarioError(f"{path}: not a replay: it has no {error}") from error
    except (AttributeError, TypeError) as error:
        raise ScenarioError(f"{path}: not a replay: {error}") from error


def _refuse(constant: str):
    # A planner may have published it, but nothing can be drawn there.
    raise ValueError(f"{constant} is not finite")


def _from_dict(content: Mapping[str, Any]) -> Replay:
    return Replay(
        walls=Shape(**content["walls"]),
        goals=content["goals"],
        road=content["road"],
        lidars=content["lidars"],
        bodies=content.get("bodies", {}),  # without: those of the F1/10 car
        global_plans=_timed(content["global_plans"]),
        local_plans=_timed(content["local_plans"]),
        models={
            name: Poses(**{**each, "shape": Shape(**each["shape"])})
            for name, each in content["models"].items()
        },
        drawings={
            topic: Timed(each["stamps"], [[Drawing(**one) for one in drawn] for drawn in each["values"]])
            for topic, each in content.get("drawings", {}).items()
        },
        channels={topic: Numbers(**each) for topic, each in content.get("channels", {}).items()},
        pictures=_timed(content.get("pictures", {})),
    )


def _timed(content):
    return {name: Timed(**each) for name, each in content.items()}
