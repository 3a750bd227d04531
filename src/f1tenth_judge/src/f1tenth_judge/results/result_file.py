"""result.json: one form, that of schema/result.schema.json, for whoever writes it and whoever reads it."""

import functools
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from f1tenth_judge.atomic import replacing
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.record.files import RESULT_FILE

SCHEMA_FILE = Path(__file__).parent.parent / "schema" / "result.schema.json"


def write_result(path: Path, content: Mapping[str, Any]) -> None:
    """Write the file, which replaces the old one when it is complete.

    `content` has no format; what else it leaves out is as the schema says.
    """
    text = json.dumps(_complete(content), indent=2, allow_nan=False)
    with replacing(path) as temporary:
        temporary.write_text(f"{text}\n", encoding="utf-8")


def read_result(path: Path) -> dict[str, Any]:
    """What a file holds.

    Raises:
        ScenarioError: it cannot be read, or is no result of this format.
    """
    try:
        result = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ScenarioError(f"{path}: not a result that can be read: {error}") from error
    wanted = _properties()["format"]["const"]
    found = result.get("format") if isinstance(result, dict) else None
    if found != wanted:
        raise ScenarioError(
            f"{path}: not a result that can be read: its format is {found}, must be {wanted}; run it again"
        )
    if missing := [name for name in _properties() if name not in result]:
        raise ScenarioError(f"{path}: not a result that can be read: it has no {', '.join(missing)}")
    return result


def read_results(folder: Path) -> dict[str, dict[str, Any]]:
    """The results of all runs of a folder, by the names of their folders.

    Raises:
        ScenarioError: there are none, or one of them cannot be read.
    """
    files = sorted(folder.glob(f"*/{RESULT_FILE}"))
    if not files:
        raise ScenarioError(f"{folder}: no results there: no folder with a {RESULT_FILE}")
    return {file.parent.name: read_result(file) for file in files}


def _complete(content: Mapping[str, Any]) -> dict[str, Any]:
    """In the order of the schema."""
    properties = _properties()
    assert content.keys() <= properties.keys(), content.keys() - properties.keys()
    return {name: _value(name, each, content) for name, each in properties.items()}


def _value(name: str, each: Mapping[str, Any], content: Mapping[str, Any]) -> Any:
    if name in content:
        return content[name]
    return each["const"] if "const" in each else each["default"]


@functools.cache
def _properties() -> Mapping[str, Any]:
    return json.loads(SCHEMA_FILE.read_text(encoding="utf-8"))["properties"]
