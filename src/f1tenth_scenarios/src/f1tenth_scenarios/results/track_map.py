"""The occupancy-grid map of a world, for pictures."""

import dataclasses
from pathlib import Path

import numpy as np
import yaml
from PIL import Image

from f1tenth_scenarios.errors import ScenarioError


@dataclasses.dataclass(frozen=True)
class TrackMap:
    """An image and the rectangle it covers in the map frame."""

    pixels: np.ndarray  # uint8, top row first
    extent: tuple[float, float, float, float]  # m: left, right, bottom, top


def read_track_map(path: Path) -> TrackMap:
    """Read a map in map_server's format.

    Raises:
        ScenarioError: it is not one.
    """
    try:
        return _read(path)
    except (OSError, ValueError, KeyError, TypeError, yaml.YAMLError) as error:
        raise ScenarioError(f"{path}: not a map: {error}") from error


def _read(path):
    description = yaml.safe_load(path.read_text(encoding="utf-8"))
    with Image.open(path.parent / description["image"]) as image:
        pixels = np.asarray(image.convert("L"))
    if description.get("negate"):
        pixels = 255 - pixels
    left, bottom = (float(value) for value in description["origin"][:2])
    height, width = (size * float(description["resolution"]) for size in pixels.shape)
    return TrackMap(pixels, (left, left + width, bottom, bottom + height))
