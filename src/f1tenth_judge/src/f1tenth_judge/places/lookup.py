"""Where scenarios, worlds, maps, goals and results are."""

import contextlib
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places.file_kind import is_place, why_no_place
from f1tenth_judge.places.packages import exports, in_package, package_path

PACKAGE = "f1tenth_scenarios"
GAZEBO_PACKAGE = "f1tenth_gazebo"

_SEARCH_PATH = "F1TENTH_SCENARIO_PATH"  # environment variable, folders as in PATH
_PACKAGE_URI = "package://"
_SUFFIXES = {"scenarios": ".yaml", "worlds": ".world", "goals": ".txt", "circuits": ".yaml"}
_SCENARIOS = ("scenarios", "circuits")  # a circuit's file is a scenario, too: a race of one lap on it
_WORDS = {"scenarios": "scenario", "worlds": "world", "goals": "goals file", "circuits": "circuit"}
_BESIDE_MAPS = (".png", ".pgm", ".csv")  # suffixes of the other files of a track
_PATH_SUFFIXES = (".yaml", ".world", ".txt", ".csv")  # of what is a path even without a slash


def add_search_path(folder: Path) -> None:
    """Also look for scenarios, worlds, goals and circuits in the folders of these names below a folder.

    It holds for this process and for those that it starts.
    """
    before = os.environ.get(_SEARCH_PATH)
    os.environ[_SEARCH_PATH] = os.pathsep.join([str(folder.resolve()), *([before] if before else [])])


def scenario_names() -> list[str]:
    """All scenarios that are found by their names: every circuit is one."""
    return sorted(
        {path.stem for kind in _SCENARIOS for folder in _folders(kind) for path in folder.glob("*.yaml")}
    )


def scenario_file(name: str) -> Path:
    """The file of a scenario, given its name or a path.

    Raises:
        ScenarioError: there is none (the message names those that exist), or it cannot name a results folder.
    """
    if not name.endswith((".yaml", ".yml")):
        return _scenario(name)
    path = Path(name).resolve()
    # Its stem becomes the name of a folder, and that of '...yaml' would be the folder above.
    if not (path.stem[0].isalnum() or path.stem[0] == "_"):
        raise ScenarioError(f"{path}: the name of a scenario file must begin with a letter or a digit")
    _refuse_place(path)
    return path


def _scenario(name: str) -> Path:
    for kind in _SCENARIOS:
        with contextlib.suppress(ScenarioError):
            return _named(kind, name)
    _refuse_place(Path(name))
    raise ScenarioError(f"no scenario '{name}'; there are: {', '.join(scenario_names())}")


def _refuse_place(path: Path) -> None:
    if os.path.isfile(path) and is_place(path):
        raise ScenarioError(f"{path} is a place, not a scenario: `f1tenth race {path}`")


def world_file(name: str, beside: Path) -> Path:
    """The file of a world, or a map that is used as one; a path is relative to the folder `beside`.

    Raises:
        ScenarioError: there is none, or it is something else; for a folder or another file of a track, the
            message names its map.
    """
    path = (beside / name).resolve()
    if path.suffix in _BESIDE_MAPS:
        raise ScenarioError(f"{path} is no world; {_maps_in(path.parent)}")
    try:
        found = _find("worlds", name, beside)
    except ScenarioError:
        if os.path.isdir(path):
            raise ScenarioError(f"{path} is no world; {_maps_in(path)}") from None
        raise
    if problem := why_no_place(found):
        raise ScenarioError(f"{found} {problem}")
    return found


def _maps_in(folder: Path) -> str:
    maps = sorted(map(str, folder.glob("*_map.yaml")))
    return (
        f"name the YAML file of its map: {', '.join(maps)}" if maps else f"there is no X_map.yaml in {folder}"
    )


def goals_file(name: str, beside: Path) -> Path:
    """A goals file; a path is relative to the folder `beside`."""
    return _find("goals", name, beside)


def course_file(name: str, beside: Path) -> Path:
    """A circuit's YAML file, or a centreline (CSV); a path is relative to the folder `beside`."""
    return _find("circuits", name, beside)


def file_at(name: str, beside: Path) -> Path:
    """A file: package://PACKAGE/PATH, or a path relative to the folder `beside`.

    Raises:
        ScenarioError: there is no such package or file.
    """
    if name.startswith(_PACKAGE_URI):
        package, _, path = name[len(_PACKAGE_URI) :].partition("/")
        return _existing(package_path(package) / path)
    return _existing((beside / name).resolve())


def file_or_text(text: str, beside: Path) -> str:
    """The path of the file that a text names as `file_at` takes it; the text if there is no such file.

    Raises:
        ScenarioError: it begins with package://, and there is no such package or file.
    """
    if text.startswith(_PACKAGE_URI):
        return str(file_at(text, beside))
    return str((beside / text).resolve()) if os.path.isfile(beside / text) else text


def portable(text: str, beside: Path) -> str:
    """The file that a path names as a scenario file on any machine would: in a package, else from `beside`.

    FILE.py:CLASS is such a path, too. A text that is not the absolute path of a file stays as it is.
    """
    name, kind = re.fullmatch(r"(.*?)((?<=\.py):\w+)?", text, re.DOTALL).groups("")  # type: ignore[union-attr]
    if not (name.startswith("/") and os.path.isfile(name)):
        return text
    return (_package_uri(Path(name)) or relative(Path(name), beside)) + kind


def relative(file: Path, beside: Path) -> str:
    """A file as it is named from a folder."""
    return os.path.relpath(file, beside.resolve())


def _package_uri(file: Path) -> Optional[str]:
    found = in_package(file)
    return f"{_PACKAGE_URI}{found[0]}/{found[1]}" if found else None


def circuits() -> list[str]:
    """Names of the circuits of f1tenth_gazebo."""
    return sorted(path.stem for path in (package_path(GAZEBO_PACKAGE) / "circuits").glob("*.yaml"))


def map_file(world: Path) -> Optional[Path]:
    """The map (YAML) of a world; nothing when it has none."""
    if world.suffix == ".yaml":
        return world
    for folder in (world.parent, world.parent.parent / "maps"):
        candidate = folder / f"{world.stem}.yaml"
        if candidate.is_file():
            return candidate
    return None


def results_root() -> Path:
    """Where all results go: $F1TENTH_RESULTS, else `results` in the working directory."""
    return Path(os.environ.get("F1TENTH_RESULTS") or "results").resolve()


def is_path(name: str) -> bool:
    """Whether a place, a course or goals are named by a path."""
    return "/" in name or Path(name).suffix in _PATH_SUFFIXES


def _find(kind: str, name: str, beside: Path) -> Path:
    if is_path(name):
        return _existing((beside / name).resolve())
    return _named(kind, name)


def _named(kind: str, name: str) -> Path:
    suffix = _SUFFIXES[kind]
    for folder in _folders(kind):
        if os.path.isfile(folder / f"{name}{suffix}"):
            return folder / f"{name}{suffix}"
    known = sorted({path.stem for folder in _folders(kind) for path in folder.glob(f"*{suffix}")})
    raise ScenarioError(f"no {_WORDS[kind]} '{name}'; there are: {', '.join(known) or 'none'}")


def _folders(kind: str) -> Iterator[Path]:
    """Where things of a kind are looked for; the first that has a name counts."""
    for folder in filter(None, os.environ.get(_SEARCH_PATH, "").split(os.pathsep)):
        yield Path(folder) / kind
    yield package_path(PACKAGE if kind == "scenarios" else GAZEBO_PACKAGE) / kind
    yield from exports(PACKAGE, kind)


def _existing(path: Path) -> Path:
    if not os.path.isfile(path):  # which knows names that are too long, too
        raise ScenarioError(f"no such file: {path}")
    return path
