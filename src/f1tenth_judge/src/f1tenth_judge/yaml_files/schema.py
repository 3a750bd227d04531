"""One description of a YAML file's keys that reads, validates and documents it.

A schema is a frozen dataclass whose keys are the fields made with `key`. Types: bool, int, float, str, an
Enum, another schema, `Optional[T]`, `tuple[T, ...]`, a NamedTuple of floats (a list of as many numbers) and
`dict[str, str]` (any keys). A field without default is a required key. A schema with a method `short_forms`
may also be given by one of these names.
"""

import dataclasses
import enum
import math
import typing
from typing import Any, Optional, TypeVar

import yaml

from f1tenth_judge.yaml_files.yaml_source import Faults, describe, error, items, scalar

T = TypeVar("T")

Problem = Optional[tuple[str, str]]
"""What a schema's method `problem` finds: a key and what is wrong with its value, or nothing."""


@dataclasses.dataclass(frozen=True)
class Key:
    """What is known of a key besides its name, type and default."""

    doc: str
    unit: str = ""
    at_least: Optional[float] = None
    above: Optional[float] = None
    at_most: Optional[float] = None

    def range_text(self) -> str:
        """The allowed range in words, empty if every value is allowed."""
        parts = [
            f"{words} {bound:.10g}{' ' + self.unit if self.unit else ''}"
            for words, bound in (
                ("at least", self.at_least),
                ("above", self.above),
                ("at most", self.at_most),
            )
            if bound is not None
        ]
        return " and ".join(parts)

    def allows(self, value: float) -> bool:
        """Whether a number lies in the range."""
        return (
            (self.at_least is None or value >= self.at_least)
            and (self.above is None or value > self.above)
            and (self.at_most is None or value <= self.at_most)
        )


def key(doc: str, *, default: Any = dataclasses.MISSING, **limits: Any) -> Any:
    """Declare a key: what it means, its default (none: required), `unit`, `at_least`, `above`, `at_most`."""
    metadata = {"key": Key(doc, **limits)}
    if default == {}:  # which a dataclass wants to have made anew
        return dataclasses.field(default_factory=dict, metadata=metadata)
    return dataclasses.field(default=default, metadata=metadata)


def is_required(field: dataclasses.Field) -> bool:
    """Whether a key must be given."""
    return field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING


def read(schema: type[T], node: yaml.Node, path: str = "") -> T:
    """Build a schema from YAML.

    Args:
        schema: the dataclass to build
        node: what the file holds there
        path: of the node inside the file, as in `cars[0].start`

    Raises:
        FileError: keys are unknown, missing, of the wrong type or out of range, a line for each of them; or
            else the schema's own `problem()` finds something.
    """
    shorts = short_forms(schema)
    if isinstance(node, yaml.ScalarNode) and node.value in shorts:
        return shorts[node.value]
    if not isinstance(node, yaml.MappingNode):
        names = f"{', '.join(shorts)}, or " if shorts else ""
        raise error(
            node, f"{path} must be {names}a mapping with the keys {_allowed(schema)}, found {describe(node)}"
        )
    faults = Faults()
    values, nodes = _read_entries(schema, node, path, faults)
    with faults.collected():
        _require_all(schema, node, path, nodes)
    faults.raise_any()
    result = schema(**values)
    _check_problem(result, node, nodes, path)
    return result


def short_forms(schema: type[T]) -> dict[str, T]:
    """What may be given by a name instead of a mapping, by name."""
    return getattr(schema, "short_forms", dict)()


def keys(schema: type) -> dict[str, Key]:
    """The keys of a schema in the order of their declaration."""
    fields = dataclasses.fields(schema)
    return {field.name: field.metadata["key"] for field in fields if "key" in field.metadata}


def _read_entries(schema, node, path, faults):
    hints = typing.get_type_hints(schema)
    known = keys(schema)
    values, nodes = {}, {}
    for name, key_node, value in items(node, faults):
        with faults.collected():
            if name not in known:
                raise error(key_node, f"unknown key '{name}'{_inside(path)}; allowed: {_allowed(schema)}")
            nodes[name] = value
            values[name] = _read_value(hints[name], known[name], value, _join(path, name))
    return values, nodes


def _require_all(schema, node, path, given):
    required = [field.name for field in dataclasses.fields(schema) if is_required(field)]
    missing = [f"'{name}'" for name in required if name not in given]
    if missing:
        several = "s" if len(missing) > 1 else ""
        names = ", ".join(missing)
        raise error(node, f"missing key{several} {names}{_inside(path)}; allowed: {_allowed(schema)}")


def _check_problem(result, node, nodes, path):
    find_problem = getattr(result, "problem", None)
    problem = find_problem() if find_problem else None
    if problem:
        name, text = problem
        raise error(nodes.get(name, node), f"{_join(path, name)} {text}")


def _read_value(hint, info, node, path):
    if typing.get_origin(hint) is tuple:
        return _read_list(typing.get_args(hint)[0], info, node, path)
    if typing.get_origin(hint) is dict:
        return _read_texts(node, path)
    if typing.get_origin(hint) is typing.Union:
        (hint,) = (option for option in typing.get_args(hint) if option is not type(None))
    if isinstance(hint, type) and dataclasses.is_dataclass(hint):
        return read(hint, node, path)
    if issubclass(hint, enum.Enum):
        return _read_choice(hint, node, path)
    if issubclass(hint, tuple):
        return _read_numbers(hint, info, node, path)
    return _read_scalar(hint, info, node, path)


def _read_list(hint, info, node, path):
    if not isinstance(node, yaml.SequenceNode):
        raise error(node, f"{path} must be a list, found {describe(node)}")
    faults, found = Faults(), []
    for index, item in enumerate(node.value):
        with faults.collected():
            found.append(_read_value(hint, info, item, f"{path}[{index}]"))
    faults.raise_any()
    return tuple(found)


def _read_numbers(hint, info, node, path):
    wanted = f"{len(hint._fields)} numbers ({', '.join(hint._fields)})"
    if not isinstance(node, yaml.SequenceNode):
        raise error(node, f"{path} must be a list of {wanted}, found {describe(node)}")
    if len(node.value) != len(hint._fields):
        raise error(node, f"{path} must be a list of {wanted}, found a list of {len(node.value)}")
    return hint(*_read_list(float, info, node, path))


def _read_texts(node, path):
    if not isinstance(node, yaml.MappingNode):
        raise error(node, f"{path} must be a mapping of names to values, found {describe(node)}")
    faults, found = Faults(), {}
    for name, _, value in items(node, faults):
        if isinstance(value, yaml.ScalarNode):
            found[name] = value.value
        else:
            faults.add(error(value, f"{_join(path, name)} must be a single value, found {describe(value)}"))
    faults.raise_any()
    return found


def _read_choice(hint, node, path):
    choices = [choice.value for choice in hint]
    if not isinstance(node, yaml.ScalarNode) or node.value not in choices:
        raise error(node, f"{path} is {describe(node)}; allowed: {', '.join(choices)}")
    return hint(node.value)


_TYPE_WORDS = {bool: "true or false", int: "a whole number", float: "a number", str: "a text"}


def _read_scalar(hint, info, node, path):
    value = scalar(node)
    if hint is float and type(value) is int:
        value = float(value)
    if type(value) is not hint or (hint is float and not math.isfinite(value)) or value == "":
        unit = f" ({info.unit})" if info.unit else ""
        raise error(node, f"{path} must be {_TYPE_WORDS[hint]}{unit}, found {describe(node)}")
    if hint is str and not value.replace("\n", "").isprintable():
        raise error(node, f"{path} must be {_TYPE_WORDS[hint]} without control characters, found {value!r}")
    if hint in (int, float) and not info.allows(value):
        raise error(node, f"{path} is {value:.10g}, must be {info.range_text()}")
    return value


def _join(path: str, name: str) -> str:
    return f"{path}.{name}" if path else name


def _inside(path: str) -> str:
    return f" in {path}" if path else ""


def _allowed(schema: type) -> str:
    return ", ".join(keys(schema))
