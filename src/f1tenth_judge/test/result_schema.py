"""What a run leaves behind, held against the schema that is shipped."""

import json

import jsonschema
from f1tenth_judge.results.result_file import SCHEMA_FILE

_SCHEMA = json.loads(SCHEMA_FILE.read_text(encoding="utf-8"))


def valid_result(path):
    """The content of a result.json, which the schema allows."""
    result = json.loads(path.read_text(encoding="utf-8"))
    jsonschema.validate(result, _SCHEMA)
    return result
