"""Places that suites make of others' tracks."""

import os
from pathlib import Path
from typing import Optional

import numpy as np
import yaml

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places.course import Course
from f1tenth_judge.places.raceline import COLUMNS, RACELINE


def data_folder() -> Path:
    """Others' tracks: $F1TENTH_DATA/tracks.

    Raises:
        ScenarioError: it is not there.
    """
    folder = Path(os.environ.get("F1TENTH_DATA", ".")) / "tracks"
    if not folder.is_dir():
        raise ScenarioError(f"{folder}: not found; F1TENTH_DATA must name the folder in which 'tracks' is")
    return folder


def track_names() -> list[str]:
    """Names of others' tracks."""
    return sorted(each.name for each in data_folder().iterdir() if each.is_dir())


def track_map(name: str) -> Path:
    """The map of one of others' tracks."""
    return data_folder() / name / f"{name}_map.yaml"


def write_place(stem: Path, map_file: Path, course: Course, line: Optional[np.ndarray] = None) -> Path:
    """Make a place from an existing map: STEM_map.yaml with another centreline beside it.

    Args:
        stem: of the files, in an existing folder
        map_file: of the road
        course: its centreline
        line: (n, 3), for drivers that follow one: x, y (m), speed (m/s)

    Returns:
        The file that names the place as a world.

    Raises:
        ScenarioError: a file cannot be read or written.
    """
    try:
        description = yaml.safe_load(map_file.read_text(encoding="utf-8"))
        description["image"] = str((map_file.parent / description["image"]).resolve())
        path = stem.with_name(f"{stem.name}_map.yaml")
        path.write_text(yaml.safe_dump(description), encoding="utf-8")
        rows = np.column_stack([course.x, course.y, course.right, course.left])
        np.savetxt(stem.with_name(f"{stem.name}_centerline.csv"), rows, fmt="%.4f", delimiter=", ")
        if line is not None:
            columns = np.zeros((len(line), 7))
            columns[:, [1, 2, 5]] = line
            target = stem.with_name(f"{stem.name}{RACELINE}")
            np.savetxt(target, columns, fmt="%.5f", delimiter="; ", header=COLUMNS)
    except OSError as error:
        raise ScenarioError(f"{error.filename}: {error.strerror}") from error
    return path
