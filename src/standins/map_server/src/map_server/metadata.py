"""The YAML file of a map: read and checked, accepted whole or not at all."""

import math
from dataclasses import dataclass
from pathlib import Path

import yaml

from map_server.errors import MapMetadataError, MapNotFoundError
from map_server.grid_map import LEAST_RESOLUTION, MOST_RESOLUTION

MODES = ("trinary", "scale", "raw")
REQUIRED_KEYS = ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")


@dataclass(frozen=True)
class MapMetadata:
    """How to understand a map's image."""

    image: Path
    resolution: float  # m, edge length of a cell
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)  # x m, y m, yaw rad of the lower left corner
    negate: bool = False
    occupied_thresh: float = 0.65
    free_thresh: float = 0.196
    mode: str = "trinary"
    unknown_keys: tuple[str, ...] = ()


def read_metadata(path):
    """Read a map's YAML file.

    Raises MapNotFoundError if there is no such file, MapMetadataError naming file and key otherwise.
    """
    path = Path(path)
    document = _document(path)
    for key in REQUIRED_KEYS:
        if key not in document:
            raise MapMetadataError(path, key, f"missing; required are {', '.join(REQUIRED_KEYS)}")
    return metadata_from(document, path)


def metadata_from(values, source):
    """Build the metadata from a mapping.

    `source` is the file it came from: errors name it, and the image is relative to its folder.
    Raises MapMetadataError.
    """
    check = _Checker(values, source)
    metadata = MapMetadata(
        image=Path(source).parent / check.text("image"),
        resolution=check.resolution(),
        origin=check.pose("origin"),
        negate=check.flag("negate"),
        occupied_thresh=check.fraction("occupied_thresh"),
        free_thresh=check.fraction("free_thresh"),
        mode=check.mode(),
        unknown_keys=tuple(sorted(key for key in values if key not in (*REQUIRED_KEYS, "mode"))),
    )
    _check_order(metadata, source)
    return metadata


def _document(path):
    """Read as the original's yaml-cpp does: the first document, and the first of two equal keys.

    Values are text, as 010 is ten in a map file and eight in YAML 1.1. Only libyaml takes tabs after a colon.
    """
    try:
        document = next(yaml.compose_all(path.read_text(encoding="utf-8"), Loader=yaml.CBaseLoader), None)
    except OSError as error:
        raise MapNotFoundError(f"{path}: cannot be opened: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise MapMetadataError(path, "", "not a YAML file: not UTF-8 text") from error
    except yaml.YAMLError as error:
        raise MapMetadataError(path, "", f"not a YAML file: {' '.join(str(error).split())}") from error
    if not isinstance(document, yaml.MappingNode):
        raise MapMetadataError(path, "", "not a map description: a mapping of keys to values is needed")
    return {str(key.value): _text_of(value) for key, value in reversed(document.value)}


def _text_of(node):
    """The text of a scalar, or of the scalars in a list; None for anything else."""
    if isinstance(node, yaml.SequenceNode):
        return [item.value if isinstance(item, yaml.ScalarNode) else None for item in node.value]
    return node.value if isinstance(node, yaml.ScalarNode) else None


def _check_order(metadata, source):
    free, occupied = metadata.free_thresh, metadata.occupied_thresh
    if free > occupied:
        raise MapMetadataError(source, "free_thresh", f"{free} is above occupied_thresh {occupied}")
    if metadata.mode == "scale" and free == occupied:
        raise MapMetadataError(
            source, "free_thresh", f"must be below occupied_thresh {occupied} in mode scale"
        )


class _Checker:
    def __init__(self, values, source):
        self._values = values
        self._source = source

    def _fail(self, key, allowed):
        raise MapMetadataError(self._source, key, f"found {self._values[key]!r}, allowed is {allowed}")

    def _number(self, value):
        if isinstance(value, bool) or not isinstance(value, (int, float, str)) or "_" in str(value):
            return math.nan
        try:
            return float(value)
        except (ValueError, OverflowError):
            return math.nan

    def text(self, key):
        value = self._values[key]
        if not isinstance(value, str) or not value:
            self._fail(key, "a file name")
        return value

    def resolution(self):
        value = self._number(self._values["resolution"])
        if not LEAST_RESOLUTION <= value <= MOST_RESOLUTION:
            self._fail("resolution", f"a number of metres from {LEAST_RESOLUTION:g} to {MOST_RESOLUTION:g}")
        return value

    def fraction(self, key):
        value = self._number(self._values[key])
        if not 0.0 <= value <= 1.0:
            self._fail(key, "a number from 0 to 1")
        return value

    def flag(self, key):
        meanings = {"0": False, "1": True, "false": False, "true": True}
        text = str(self._values[key]).lower()
        if text not in meanings:
            self._fail(key, "0 or 1")
        return meanings[text]

    def pose(self, key):
        value = self._values[key]
        numbers = [self._number(number) for number in value[:3]] if isinstance(value, list) else []
        if len(numbers) != 3 or not all(math.isfinite(number) for number in numbers):
            self._fail(key, "three numbers: x, y, yaw")
        return tuple(numbers)

    def mode(self):
        value = self._values.get("mode", "trinary")
        if value not in MODES:
            self._fail("mode", " or ".join(MODES))
        return value
