"""The README's table of keys is the schema's."""

from pathlib import Path

from f1tenth_judge.scenario.describe import describe_keys
from f1tenth_judge.scenario.scenario import Scenario


def test_readme_holds_every_key_as_the_schema_has_it():
    readme = Path(__file__).parents[1] / "README.md"
    assert f"\n\n{describe_keys(Scenario)}\n\n" in readme.read_text(encoding="utf-8")
