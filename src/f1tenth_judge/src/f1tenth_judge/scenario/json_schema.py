"""Writes the JSON Schema of scenario files: python3 -m f1tenth_judge.scenario.json_schema."""

import json
from pathlib import Path

from f1tenth_judge.scenario.scenario import Scenario
from f1tenth_judge.yaml_files.json_schema import json_schema

SCHEMA_FILE = Path(__file__).parent.parent / "schema" / "scenario.schema.json"


def scenario_schema_text() -> str:
    """What the file holds."""
    return json.dumps(json_schema(Scenario, "Scenario of f1tenth_judge"), indent=2) + "\n"


if __name__ == "__main__":
    SCHEMA_FILE.write_text(scenario_schema_text(), encoding="utf-8")
