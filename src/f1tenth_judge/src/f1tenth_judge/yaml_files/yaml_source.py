"""YAML text as a tree of nodes that remember their lines, so that an error can name its place."""

import contextlib
import os
import re
from collections.abc import Iterator
from pathlib import Path

import yaml

from f1tenth_judge.errors import FileError

_LARGEST = 1_000_000  # bytes, of a file that somebody writes by hand
_NUMBER = re.compile(r"[-+]?(?:0|[1-9][0-9]*|(?=\.[0-9]))(\.[0-9]*)?([eE][-+]?[0-9]+)?")
_NUMBER_TAGS = {f"tag:yaml.org,2002:{name}" for name in ("int", "float", "str")}  # 1e3 is a text to PyYAML
TOO_DEEP = "lists or mappings are nested too deeply"


def error(node: yaml.Node, text: str) -> FileError:
    """What is wrong at a node: FILE:LINE: text."""
    line = text.replace("\n", "\\n")  # of what was found, too
    return FileError(f"{node.start_mark.name}:{node.start_mark.line + 1}: {line}")


def compose(path: Path) -> yaml.MappingNode:
    """Read a file whose top level is a mapping.

    Raises:
        FileError: the file cannot be read, is not YAML, or holds something other than a mapping.
    """
    try:
        with open(path, encoding="utf-8") as stream:
            _check_size(path, os.fstat(stream.fileno()).st_size)
            root = yaml.compose(stream, Loader=yaml.SafeLoader)
    except RecursionError as problem:
        raise FileError(f"{path}: {TOO_DEEP}") from problem
    except OSError as problem:
        raise FileError(f"{path}: cannot be read: {problem.strerror}") from problem
    except yaml.MarkedYAMLError as problem:
        line = problem.problem_mark.line + 1 if problem.problem_mark else 1
        raise FileError(f"{path}:{line}: not YAML: {problem.problem}") from problem
    except (yaml.YAMLError, UnicodeDecodeError) as problem:
        raise FileError(f"{path}: not YAML: {' '.join(str(problem).split())}") from problem
    if not isinstance(root, yaml.MappingNode):
        raise FileError(f"{path}:1: must be a mapping of keys to values")
    return root


class Faults:
    """Faults of a file that are found while the rest of it is read on."""

    def __init__(self):
        self._found: list[FileError] = []

    def add(self, fault: FileError) -> None:
        """Keep one for later."""
        self._found.append(fault)

    @contextlib.contextmanager
    def collected(self) -> Iterator[None]:
        """Keep a FileError of the block for later."""
        try:
            yield
        except FileError as fault:
            self.add(fault)

    def raise_any(self) -> None:
        """Raise what was found as one error: a line each, in the order of the file."""
        if self._found:
            raise FileError("\n".join(map(str, self._found)))


def _check_size(path: Path, size: int) -> None:
    if size > _LARGEST:
        raise FileError(f"{path}: has {size / 1e6:.1f} MB, must have at most {_LARGEST / 1e6:.1f}")


def items(node: yaml.MappingNode, faults: Faults) -> Iterator[tuple[str, yaml.Node, yaml.Node]]:
    """The entries of a mapping in order: the key's text, the key and the value.

    A key that is given a second time is left out, and among the faults.
    """
    seen: dict[str, yaml.Node] = {}
    for key, value in node.value:
        if not isinstance(key, yaml.ScalarNode):
            faults.add(error(key, f"a key must be a text, found {describe(key)}"))
            continue
        name = str(key.value)
        if name in seen:
            first = seen[name].start_mark.line + 1
            faults.add(error(key, f"key '{name}' is given twice, first in line {first}"))
            continue
        seen[name] = key
        yield name, key, value


def scalar(node: yaml.Node):
    """The Python value of a node; None for a list, a mapping, a tag that is not YAML's own, and odd numbers.

    Numbers are those of YAML 1.2: by 1.1, 1e3 is a text, and 010, 1:30 and 1_000 are 8, 90 and 1000.
    """
    if not isinstance(node, yaml.ScalarNode):
        return None
    is_known = node.tag in _NUMBER_TAGS and node.style is None
    if is_known and (number := _NUMBER.fullmatch(node.value)):
        return float(node.value) if any(number.groups()) else int(node.value)
    try:
        value = yaml.constructor.SafeConstructor().construct_object(node)
    except (yaml.YAMLError, ValueError):
        return None
    return None if type(value) in (int, float) else value


def describe(node: yaml.Node) -> str:
    """What was found, for error messages."""
    if isinstance(node, yaml.MappingNode):
        return "a mapping"
    if isinstance(node, yaml.SequenceNode):
        return "a list"
    return f"'{node.value}'" if node.value else "nothing"
