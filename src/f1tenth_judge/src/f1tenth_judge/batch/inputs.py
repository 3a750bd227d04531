"""What the result of a run depends on, as a hash: an old result counts for as long as it stays the same."""

import contextlib
import dataclasses
import hashlib
import modulefinder
import os
from collections.abc import Iterable, Iterator
from pathlib import Path

import yaml

import f1tenth_judge
import f1tenth_sim2d
from f1tenth_judge.places.packages import package_names, package_path
from f1tenth_judge.plan.hand_off import given_arguments
from f1tenth_judge.plan.plan import Plan

# Where the system's packages put theirs; elsewhere below /opt and /usr a workspace may be.
_INSTALLED = ("/opt/ros", "/usr/share", "/usr/lib")
_IRRELEVANT_FOLDERS = ("__pycache__", "test", "docs")
_IRRELEVANT_SUFFIXES = (".md", ".rst", ".pyc", ".log")


def hash_software() -> str:
    """Hash of all packages of the workspaces that are sourced, and of what was built from them."""
    return _hash_files(file for folder in _workspace_folders() for file in _files(folder))


def hash_inputs(plan: Plan, software: str) -> str:
    """Hash of the software and of everything that a scenario names, its settings included."""
    files = sorted({*_paths(plan), *_images(plan), *_driver_files(plan)})
    # What a xacro file includes is in the text that it expands to.
    texts = [car.description.text for car in plan.cars.values() if car.description]
    known = [software, *plan.settings, _hash_files(files), *texts]
    return hashlib.sha256("\n".join(known).encode()).hexdigest()


def _workspace_folders() -> list[str]:
    sources = sorted(str(package_path(name)) for name in package_names())
    modules = [*f1tenth_judge.__path__, *f1tenth_sim2d.__path__]
    prefixes = filter(None, os.environ.get("CMAKE_PREFIX_PATH", "").split(":"))
    built = [f"{prefix}/lib" for prefix in prefixes]
    return [each for each in [*sources, *modules, *built] if not _is_installed(Path(each))]


def _is_installed(folder: Path) -> bool:
    return any(folder.is_relative_to(each) for each in _INSTALLED)


def _files(folder: str) -> Iterator[Path]:
    for parent, folders, names in os.walk(folder):
        folders[:] = sorted(
            each for each in folders if each not in _IRRELEVANT_FOLDERS and not each.startswith(".")
        )
        yield from (Path(parent, name) for name in sorted(names) if not name.endswith(_IRRELEVANT_SUFFIXES))


def _paths(value) -> list[Path]:
    if isinstance(value, dict):
        return [path for each in value.values() for path in _paths(each)]
    if dataclasses.is_dataclass(value):
        return [path for field in dataclasses.fields(value) for path in _paths(getattr(value, field.name))]
    return [value] if isinstance(value, Path) else []


def _images(plan: Plan) -> list[Path]:
    """The image files of the map; none if it cannot be read, which the run will report."""
    if plan.place.map is None:
        return []
    with contextlib.suppress(OSError, ValueError, KeyError, TypeError, yaml.YAMLError):
        return [plan.place.map.parent / yaml.safe_load(plan.place.map.read_text(encoding="utf-8"))["image"]]
    return []


def _driver_files(plan: Plan) -> Iterator[Path]:
    """Files that drivers are told of, and those beside them that they may use."""
    for car in plan.scenario.cars:
        yield from (Path(text) for text in given_arguments(plan, car).values() if text.startswith("/"))
        driver = plan.cars[car.name].driver
        # Not what is in folders below it: results may be there.
        beside = [file for file in driver.folder.iterdir() if not file.name.endswith(_IRRELEVANT_SUFFIXES)]
        yield from _used(driver.path, beside) if car.driver.python else beside


def _used(file: Path, beside: Iterable[Path]) -> Iterator[Path]:
    """A Python file, what it imports from its folder, and data files there of kinds that the code names.

    Other planners in the folder, and the file of their league, are no reason to race this one again.
    """
    finder = modulefinder.ModuleFinder([str(file.parent)])
    with contextlib.suppress(SyntaxError, OSError):
        finder.run_script(str(file))
    found = (getattr(each, "__file__", None) for each in finder.modules.values())
    modules = {file, *map(Path, filter(None, found))}
    text = "".join(each.read_text(encoding="utf-8", errors="replace") for each in modules)
    yield from modules
    yield from (each for each in beside if each.suffix != ".py" and (each.suffix or each.name) in text)


def _hash_files(files: Iterable[Path]) -> str:
    found = hashlib.sha256()
    for file in files:
        with contextlib.suppress(OSError):  # what we cannot read is not read by a run either
            if file.is_file():
                content = file.read_bytes()
                found.update(f"{file}\n{len(content)}\n".encode() + content)
    return found.hexdigest()
