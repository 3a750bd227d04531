"""result.json is written and read in one form; every test of a run holds it against the schema."""

import json

import jsonschema
import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.results.result_file import SCHEMA_FILE, read_result, read_results, write_result
from report_samples import result
from result_schema import valid_result

SCHEMA = json.loads(SCHEMA_FILE.read_text(encoding="utf-8"))


def test_schema_is_one_and_asks_for_every_key():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert SCHEMA["required"] == list(SCHEMA["properties"])


def test_what_is_left_out_is_as_the_schema_says(tmp_path):
    content = result("one")
    del content["culprit"]
    write_result(tmp_path / "result.json", content)
    written = valid_result(tmp_path / "result.json")
    assert list(written) == list(SCHEMA["properties"])
    assert (written["format"], written["culprit"], written["settings"]) == (1, None, [])
    assert read_result(tmp_path / "result.json") == written


def test_key_that_the_schema_does_not_know_is_not_written(tmp_path):
    with pytest.raises(AssertionError, match="colour"):
        write_result(tmp_path / "result.json", {**result("one"), "colour": "red"})
    assert not (tmp_path / "result.json").exists()


def test_key_that_every_run_must_say_is_not_made_up(tmp_path):
    content = result("one")
    del content["verdict"]
    with pytest.raises(KeyError):
        write_result(tmp_path / "result.json", content)


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("{", "Expecting property name"),
        ("[]", "its format is None, must be 1; run it again"),
        ("{}", "its format is None, must be 1; run it again"),
        ('{"format": 2}', "its format is 2, must be 1; run it again"),
        ('{"format": 1, "scenario": "one"}', "it has no description, world, verdict, "),
    ],
)
def test_what_is_no_result_is_named(tmp_path, text, problem):
    file = tmp_path / "result.json"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(ScenarioError) as error:
        read_result(file)
    assert str(error.value).startswith(f"{file}: not a result that can be read: {problem}")


def test_results_are_read_by_the_names_of_their_folders(tmp_path):
    for name in ("b", "a"):
        (tmp_path / name).mkdir()
        write_result(tmp_path / name / "result.json", result(f"scenario {name}"))
    assert [each["scenario"] for each in read_results(tmp_path).values()] == ["scenario a", "scenario b"]
    with pytest.raises(ScenarioError, match="no results there: no folder with a result.json"):
        read_results(tmp_path / "a")
