"""The keys of a schema as a Markdown table, so that document and validation cannot differ."""

import dataclasses
import enum
import typing

from f1tenth_judge.yaml_files.schema import is_required, keys, short_forms

_WORDS = {bool: "true, false", int: "whole number", float: "number", str: "text"}


def describe_keys(schema: type) -> str:
    """One row per key: name, type and allowed values, unit, default, meaning."""
    rows = ["| key | value | unit | default | meaning |", "| --- | --- | --- | --- | --- |"]
    return "\n".join([*rows, *_rows(schema, "")])


def _rows(schema, prefix):
    hints = typing.get_type_hints(schema)
    for field in dataclasses.fields(schema):
        info, (hint, mark) = keys(schema)[field.name], _unwrap(hints[field.name])
        name = f"{prefix}{field.name}{mark}"
        yield f"| `{name}` | {_value(hint, info)} | {info.unit} | {_default(field)} | {info.doc} |"
        if dataclasses.is_dataclass(hint):
            yield from _rows(hint, f"{name}.")


def _unwrap(hint):
    if typing.get_origin(hint) is tuple:
        return typing.get_args(hint)[0], "[]"
    if typing.get_origin(hint) is typing.Union:
        return next(option for option in typing.get_args(hint) if option is not type(None)), ""
    return hint, ""


def _value(hint, info):
    if typing.get_origin(hint) is dict:
        return "mapping of names to values"
    if isinstance(hint, type) and dataclasses.is_dataclass(hint):
        return ", ".join([*(f"`{name}`" for name in short_forms(hint)), "mapping"])
    if issubclass(hint, enum.Enum):
        return ", ".join(f"`{choice.value}`" for choice in hint)
    return ", ".join(filter(None, (_WORDS[hint], info.range_text())))


def _default(field):
    if is_required(field):
        return "required"
    if field.default is dataclasses.MISSING:
        return "none"
    for name, value in short_forms(type(field.default)).items():
        if field.default == value:
            return f"`{name}`"
    if isinstance(field.default, enum.Enum):
        return f"`{field.default.value}`"
    if field.default is None or field.default == ():
        return "none"
    if dataclasses.is_dataclass(field.default):
        return _default_of_mapping(field.default)
    return f"{field.default}".lower() if isinstance(field.default, bool) else f"{field.default}"


def _default_of_mapping(value):
    """What its own keys' defaults do not say already."""
    needed = [field.name for field in dataclasses.fields(value) if is_required(field)]
    return ", ".join(f"{name} {getattr(value, name)}" for name in needed) or "its keys' defaults"
