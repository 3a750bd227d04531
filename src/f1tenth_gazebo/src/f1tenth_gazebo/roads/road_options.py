"""What a random road is to be like."""

import math
from dataclasses import asdict, dataclass, field, fields, replace

import numpy as np

CAR_RADIUS = 0.7415
"""Least turning radius of the F1/10 car, m: 0.3302 m / tan(0.4189 rad)."""
MIN_RADIUS = 1.1 * CAR_RADIUS
"""Least radius that a road may have, m."""
MIN_WIDTH = 1.2
"""The least width of a road, and of a passage beside an island, m."""
ISLAND_RADII = (0.1, 0.3)
"""m"""


class RoadError(Exception):
    """A road that cannot be made; one line: which option, what was found, what is allowed."""


def _option(least, greatest, what):
    return field(metadata={"limits": (least, greatest), "help": what})


@dataclass(frozen=True)
class RoadOptions:
    """Everything about a road but its seed, each with its limits. Lengths are in m."""

    length: float = _option(30.0, 400.0, "of one lap, m")
    # (least, greatest): between places of both it changes evenly.
    width: tuple = _option(
        MIN_WIDTH, 4.0, "between the walls, m; LOW:HIGH for a road that is not everywhere as wide"
    )
    radius: float = _option(math.floor(1000.0 * MIN_RADIUS) / 1000.0, 5.0, "least one of the way around, m")
    straight: float = _option(3.0, 80.0, "length of the longest straight, m, at most a third of the length")
    hairpins: int = _option(0, 8, "half circles with the way back beside the way there")
    chicanes: int = _option(0, 8, "steps aside and back")
    cell: float = _option(0.03, 0.1, "edge of a cell of the map, m")
    raggedness: float = _option(0.0, 0.15, "how far the walls stand back from the road at random, m")
    gaps: int = _option(0, 40, "holes in the walls, narrower than the car")
    # Beside each there is a way as wide as MIN_WIDTH.
    islands: int = _option(0, 10, "round obstacles on the road")

    def __post_init__(self):
        """Raise RoadError for values that no road can have."""
        for name in LIMITS:
            _require_within_limits(name, getattr(self, name))
        self._check_together()

    def _check_together(self):
        if len(self.width) != 2 or self.width[0] > self.width[1]:
            found = ":".join(f"{width:g}" for width in self.width)
            raise RoadError(f"width: found {found}, allowed: a width, or the least and the greatest")
        if self.straight > self.length / 3.0 + 1e-9:
            third = f"{self.length / 3.0:.1f}"
            raise RoadError(
                f"straight: found {self.straight:g}, allowed: up to a third of the length, {third}"
            )
        needed = MIN_WIDTH + 2.0 * ISLAND_RADII[0]
        if self.islands and self.width[1] < needed:
            raise RoadError(
                f"islands: found {self.islands} on a road {self.width[1]:g} wide, allowed: from {needed:g} on"
            )


LIMITS: dict[str, tuple[float, float]] = {each.name: each.metadata["limits"] for each in fields(RoadOptions)}
"""Least and greatest value of each option."""


def drawn_options(rng, **given):
    """Random options, except those given. What a seed draws for the others does not depend on the given ones.

    Raises:
        RoadError: for a name that is not an option, or a value that is not allowed.
    """
    unknown = sorted(given.keys() - LIMITS.keys())
    if unknown:
        raise RoadError(f"{unknown[0]}: no such option, allowed: {', '.join(LIMITS)}")
    for name, value in given.items():
        _require_within_limits(name, value)
    share = rng.uniform(size=13)
    length = given.get("length") or _between(*LIMITS["length"], share[0], logarithmic=True)
    width = given.get("width") or _drawn_width(length, share[1:3])
    width = tuple(float(w) for w in np.atleast_1d(width))
    width = width * 2 if len(width) == 1 else width
    options = RoadOptions(
        length=length,
        width=width,
        radius=_between(LIMITS["radius"][0], 2.0, share[3], logarithmic=True),
        straight=_between(4.0, min(80.0, max(5.0, 0.25 * length)), share[4], logarithmic=True),
        hairpins=int(share[5] * (1.5 + min(length / 60.0, 4.0))),
        chicanes=int(share[6] * (1.5 + min(length / 60.0, 4.0))),
        cell=_between(*LIMITS["cell"], share[7]),
        raggedness=0.0 if share[8] < 0.4 else _between(0.02, 0.12, share[9]),
        gaps=0 if share[10] < 0.4 else int(share[11] * min(40.0, length / 10.0)),
        islands=0 if width[1] < MIN_WIDTH + 4 * ISLAND_RADII[0] else int(share[12] * (1.5 + length / 100.0)),
    )
    return replace(options, **{k: v for k, v in given.items() if k not in ("length", "width")})


def _require_within_limits(name, values):
    low, high = LIMITS[name]
    for value in np.atleast_1d(values):
        if not (isinstance(value, (int, float, np.number)) and low <= value <= high):
            raise RoadError(f"{name}: found {value}, allowed: {low:g} to {high:g}")


def describe(options):
    """The options as one line."""
    return ", ".join(f"{name} {_text(value)}" for name, value in asdict(options).items())


def _drawn_width(length, share):
    least = _between(MIN_WIDTH, min(3.2, max(1.3, length / 16.0)), share[0], logarithmic=True)
    # Half of the roads have the same width everywhere.
    return (least, min(4.0, least * (1.0 + max(0.0, share[1] - 0.5))))


def _between(low, high, share, logarithmic=False):
    return float(low * (high / low) ** share if logarithmic else low + share * (high - low))


def _text(value):
    return ":".join(f"{v:.3g}" for v in value) if isinstance(value, tuple) else f"{value:.4g}"
