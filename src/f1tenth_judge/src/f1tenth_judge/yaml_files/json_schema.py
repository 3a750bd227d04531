"""A schema of `schema.py` as JSON Schema, by which editors complete and check a file while it is written.

It says of each key what `read` asks for; rules between keys are the schema's own.
"""

import dataclasses
import enum
import typing
from typing import Any

from f1tenth_judge.yaml_files.schema import Key, is_required, keys, short_forms

_DIALECT = "https://json-schema.org/draft/2020-12/schema"
_TYPES = {bool: {"type": "boolean"}, int: {"type": "integer"}, float: {"type": "number"}}
_BOUNDS = {"at_least": "minimum", "above": "exclusiveMinimum", "at_most": "maximum"}


def json_schema(schema: type, title: str) -> dict[str, Any]:
    """The whole, with every schema in it written out once."""
    definitions: dict[str, Any] = {}
    whole = _mapping(schema, definitions)
    return {"$schema": _DIALECT, "title": title, **whole, "$defs": definitions}


def _mapping(schema: type, definitions: dict[str, Any]) -> dict[str, Any]:
    hints = typing.get_type_hints(schema)
    known = keys(schema)
    required = [field.name for field in dataclasses.fields(schema) if is_required(field)]
    return {
        "type": "object",
        "properties": {name: _property(hints[name], info, definitions) for name, info in known.items()},
        "required": required,
        "additionalProperties": False,
    }


def _property(hint: Any, info: Key, definitions: dict[str, Any]) -> dict[str, Any]:
    unit = f" In {info.unit}." if info.unit else ""
    return {"description": f"{info.doc}{unit}", **_value(hint, info, definitions)}


def _value(hint: Any, info: Key, definitions: dict[str, Any]) -> dict[str, Any]:
    origin, inner = typing.get_origin(hint), typing.get_args(hint)
    if origin is tuple:
        return {"type": "array", "items": _value(inner[0], info, definitions)}
    if origin is dict:
        return {"type": "object", "additionalProperties": {"type": ["string", "number", "boolean", "null"]}}
    if origin is typing.Union:
        return _value(next(each for each in inner if each is not type(None)), info, definitions)
    if dataclasses.is_dataclass(hint):
        return _part(hint, definitions)
    if issubclass(hint, enum.Enum):
        return {"enum": [choice.value for choice in hint]}
    if issubclass(hint, tuple):
        count = len(hint._fields)
        return {"type": "array", "items": _scalar(float, info), "minItems": count, "maxItems": count}
    return _scalar(hint, info)


def _scalar(hint: type, info: Key) -> dict[str, Any]:
    if hint is str:
        return {"type": "string", "minLength": 1}
    bounds = {word: getattr(info, name) for name, word in _BOUNDS.items()}
    return _TYPES[hint] | {word: bound for word, bound in bounds.items() if bound is not None}


def _part(schema: Any, definitions: dict[str, Any]) -> dict[str, Any]:
    name = schema.__name__
    if name not in definitions:
        definitions[name] = {}  # a schema may hold itself
        words = list(short_forms(schema))
        mapping = _mapping(schema, definitions)
        definitions[name] = {"anyOf": [{"enum": words}, mapping]} if words else mapping
    return {"$ref": f"#/$defs/{name}"}
