"""Editors check a scenario file by a JSON Schema that says the same as the judge's own."""

import json

import jsonschema
import pytest
import yaml
from f1tenth_judge.places import lookup
from f1tenth_judge.scenario.json_schema import SCHEMA_FILE, scenario_schema_text
from scenario_samples import SCENARIO_TEXT

SCHEMA = json.loads(SCHEMA_FILE.read_text(encoding="utf-8"))
SHIPPED = sorted((lookup.package_path(lookup.PACKAGE) / "scenarios").glob("*.yaml"))


def is_valid(content):
    return jsonschema.Draft202012Validator(SCHEMA).is_valid(content)


def test_file_is_what_is_made_of_the_schema():
    said = "python3 -m f1tenth_judge.scenario.json_schema writes it anew"
    assert SCHEMA_FILE.read_text(encoding="utf-8") == scenario_schema_text(), said
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("file", SHIPPED, ids=lambda file: file.stem)
def test_every_shipped_scenario_is_valid(file):
    jsonschema.validate(yaml.safe_load(file.read_text(encoding="utf-8")), SCHEMA)


@pytest.mark.parametrize(
    "change",
    [
        {"colour": "red"},
        {"seed": -1},
        {"seed": "one"},
        {"lockstep": "yes, please"},
        {"expected": "victory"},
        {"limits": {"timeout": 0}},
        {"limits": {}},
        {"cars": {"name": "robot1"}},
        {"cars": [{"name": "robot1", "start": {"x": "left"}}]},
        {"cars": [{"name": "robot1", "driver": "nobody"}]},
        {"reason": ""},
    ],
)
def test_what_the_judge_refuses_is_refused(change):
    content = yaml.safe_load(SCENARIO_TEXT)
    assert is_valid(content)
    assert not is_valid(content | change)


def test_words_lists_and_mappings_of_drivers_are_allowed():
    content = yaml.safe_load(SCENARIO_TEXT)
    for driver in ("race", {"launch": "my.launch", "arguments": {"speed": 2.5, "name": "x"}}):
        assert is_valid(content | {"cars": [{"name": "robot1", "driver": driver, "goals": "circuit1"}]})
    assert is_valid(content | {"boxes": [{"name": "b", "x": 1, "y": 2.5, "pushes": [{"at": 1, "speed": 2}]}]})
