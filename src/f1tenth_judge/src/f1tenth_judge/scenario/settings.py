"""Values of a scenario's keys that are set from outside of its file, as in `mu=0.3`."""

import collections
import dataclasses
import math
import re
import typing
from collections.abc import Sequence
from typing import Any, Optional

import numpy as np
import yaml

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.scenario.car import Car
from f1tenth_judge.scenario.scenario import Scenario
from f1tenth_judge.scenario.yaml_text import compose_text
from f1tenth_judge.yaml_files.schema import keys

_MOST_VALUES = 100_000


@dataclasses.dataclass(frozen=True)
class Setting:
    """A key and its value as YAML text.

    The key is one of the scenario (`seed`), one inside a mapping (`limits.timeout`), one of the entry with a
    name (`cars.robot2.speed_max`), or one of a car (`mu`, `driver.arguments.speed`), which then counts for
    all cars; inside `driver` for those whose driver is a mapping.
    """

    key: str
    value: str

    def __str__(self) -> str:
        return f"{self.key}={self.value}"


def parse_setting(text: str) -> Setting:
    """Read KEY=VALUE.

    Raises:
        ScenarioError: it is not of this form.
    """
    key, equals, value = text.partition("=")
    if not (key and equals and value):
        raise ScenarioError(f"'{text}' must be KEY=VALUE, as in mu=0.3")
    return Setting(key, value)


def apply_settings(root: yaml.MappingNode, settings: Sequence[Setting]) -> None:
    """Put the settings into a scenario's YAML tree.

    Raises:
        ScenarioError: there is no such key, or the value is not YAML.
    """
    for setting in settings:
        value = compose_text(setting.value, str(setting))
        *path, last = setting.key.split(".")
        for node in _bearers(root, setting):
            _put(_descend(node, path, setting), last, value)


def unit_of(key: str) -> str:
    """The unit of a key that can be set; empty if it has none."""
    path = key.split(".")
    schema = Scenario if path[0] in keys(Scenario) else Car
    unit = ""
    for name in path:
        # A part that is not a key is the name of an entry.
        if dataclasses.is_dataclass(schema) and name in keys(schema):
            unit, schema = keys(schema)[name].unit, _inner(typing.get_type_hints(schema)[name])
    return unit


def _inner(hint: Any) -> Any:
    """What an optional value or a list holds."""
    arguments = [each for each in typing.get_args(hint) if each not in (type(None), ...)]
    return arguments[0] if arguments else hint


def parse_variation(text: str) -> list[Setting]:
    """Read the values of a key: `seed=1:50` (whole numbers), `mu=0.3:1.0:8` (so many, evenly), `world=a,b`.

    Values may be YAML in brackets, `boxes=[],[{name: box, x: 3, y: 0}]`.

    Raises:
        ScenarioError: it is none of these, or names a value twice.
    """
    setting = parse_setting(text)
    parts = setting.value.split(":")
    if setting.value[0] in "[{":
        values = _split_beside_brackets(setting.value)
    elif len(parts) == 3:
        values = _evenly_spaced(text, *parts)
    elif len(parts) == 2:
        values = _whole_numbers(text, *parts)
    else:
        values = setting.value.split(",")
    value, count = collections.Counter(values).most_common(1)[0]
    if count > 1:
        raise ScenarioError(f"'{text}' has the value {value} more than once")
    return [Setting(setting.key, value) for value in values]


def _split_beside_brackets(text: str) -> list[str]:
    values, depth = [""], 0
    for letter in text:
        depth += (letter in "[{") - (letter in "]}")
        if letter == "," and depth == 0:
            values.append("")
        else:
            values[-1] += letter
    return values


def _evenly_spaced(text: str, first: str, last: str, count: str) -> list[str]:
    number = _read(text, int, count, "the number of values must be a whole number")
    _check_count(text, number)
    begin, end = (_read(text, float, each, "must be a number") for each in (first, last))
    return [f"{value:.6g}" for value in np.linspace(begin, end, number)]


def _whole_numbers(text: str, first: str, last: str) -> list[str]:
    ends = [_read(text, int, end, "must be a whole number") for end in (first, last)]
    _check_count(text, ends[1] - ends[0] + 1)
    return [str(value) for value in range(ends[0], ends[1] + 1)]


def _read(text, kind, value, rule):
    try:
        number = kind(value)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        allowed = "allowed are FIRST:LAST (whole numbers), FIRST:LAST:COUNT, and A,B,…"
        raise ScenarioError(f"'{text}': {rule}, found '{value}'; {allowed}")
    return number


def _check_count(text: str, count: int) -> None:
    if not 0 < count <= _MOST_VALUES:
        raise ScenarioError(f"'{text}' stands for {max(count, 0)} values, must be 1 to {_MOST_VALUES}")


def folder_name(settings: Sequence[Setting]) -> str:
    """A folder's name for a combination."""
    return ",".join(re.sub(r"[^A-Za-z0-9_.=+-]", "_", str(each)) for each in settings)


def _bearers(root: yaml.MappingNode, setting: Setting) -> list[yaml.MappingNode]:
    """The scenario, or all cars that have such a key."""
    first, *others = setting.key.split(".")
    if first in keys(Scenario):
        return [root]
    if first not in keys(Car):
        allowed = "the keys that `f1tenth keys` lists, and driver.arguments.NAME for an argument of a planner"
        raise ScenarioError(f"{setting}: unknown key '{first}'; allowed: {allowed}")
    cars = _cars(root)
    if first != "driver" or not others:
        return cars
    # A driver that is a word, or ours because none is named, has no keys of its own.
    able = [car for car in cars if isinstance(_entry(car, first), yaml.MappingNode)]
    if not able:
        where = "cars whose driver is a mapping, as in {launch: my.launch}"
        raise ScenarioError(f"{setting}: is for {where}; there is none")
    return able


def _cars(root: yaml.MappingNode) -> list[yaml.MappingNode]:
    """Those that are mappings: what is wrong with others is reported when the file is read."""
    cars = next((value for key, value in root.value if key.value == "cars"), None)
    entries = cars.value if isinstance(cars, yaml.SequenceNode) else []
    return [each for each in entries if isinstance(each, yaml.MappingNode)]


def _descend(node, path, setting):
    for name in path:
        found = _entry(node, name)
        if found is None and isinstance(node, yaml.MappingNode):
            found = yaml.MappingNode("tag:yaml.org,2002:map", [], node.start_mark, node.end_mark)
            node.value.append((_name_node(name, node), found))
        if found is None:
            names = ", ".join(filter(None, map(_name_of, node.value))) or "none"
            raise ScenarioError(f"{setting}: there is no {name}, there are: {names}")
        if not isinstance(found, (yaml.MappingNode, yaml.SequenceNode)):
            raise ScenarioError(f"{setting}: {name} holds no keys")
        node = found
    if not isinstance(node, yaml.MappingNode):
        raise ScenarioError(f"{setting}: must name one of {path[-1]}, as in {path[-1]}.robot1")
    return node


def _entry(node: yaml.Node, name: str) -> Optional[yaml.Node]:
    """What a mapping holds under a name, or the mapping of that name in a list."""
    if isinstance(node, yaml.MappingNode):
        return next((value for key, value in node.value if key.value == name), None)
    return next((each for each in node.value if _name_of(each) == name), None)


def _name_of(node: yaml.Node) -> Optional[str]:
    """What a mapping in a list calls itself."""
    name = _entry(node, "name") if isinstance(node, yaml.MappingNode) else None
    return name.value if isinstance(name, yaml.ScalarNode) else None


def _put(node: yaml.MappingNode, name: str, value: yaml.Node) -> None:
    node.value = [(key, old) for key, old in node.value if key.value != name]
    node.value.append((_name_node(name, value), value))


def _name_node(name: str, beside: yaml.Node) -> yaml.ScalarNode:
    return yaml.ScalarNode("tag:yaml.org,2002:str", name, beside.start_mark, beside.end_mark)
