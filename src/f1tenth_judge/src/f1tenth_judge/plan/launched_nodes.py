"""Whether the nodes of a planner's launch file can be started, as far as that is known before the start."""

import difflib
import os
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places.packages import package_names, package_path

_CONDITIONS = ("if", "unless")


def check_nodes(launch_file: Path) -> None:
    """Refuse a launch file with a node whose package or program is not there, or cannot be run.

    What depends on arguments or conditions is left to roslaunch.

    Raises:
        ScenarioError: with the node, and what to do.
    """
    for node in _certain(ElementTree.parse(launch_file).getroot()):
        package, program = node.get("pkg", ""), node.get("type", "")
        if package and program and "$(" not in package + program:
            where = f"{launch_file}: node '{node.get('name', program)}'"
            _check_program(where, package, program)


def _certain(tag: ElementTree.Element) -> Iterator[ElementTree.Element]:
    """The nodes without a condition around them."""
    for child in tag:
        if not any(child.get(condition) for condition in _CONDITIONS):
            yield from [child] if child.tag == "node" else _certain(child)


def _check_program(where: str, package: str, program: str) -> None:
    known = set(package_names())
    if package not in known:
        near = difflib.get_close_matches(package, known, 1)
        hint = f"; is '{near[0]}' meant?" if near else "; is its workspace sourced?"
        raise ScenarioError(f"{where}: there is no package '{package}'{hint}")
    found = [file for file in _candidates(package, program) if file.is_file()]
    if not found:
        raise ScenarioError(f"{where}: package '{package}' has no program '{program}'; is it built?")
    if not any(os.access(file, os.X_OK) for file in found):
        raise ScenarioError(f"{where}: {found[0]} is not executable; run: chmod +x {found[0]}")


def _candidates(package: str, program: str) -> Iterator[Path]:
    prefixes = filter(None, os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep))
    yield from (Path(prefix, "lib", package, program) for prefix in [*prefixes, "/usr"])
    yield from package_path(package).rglob(program)
