"""What the mutants of tools/*mutants.yaml name is there: a change of the code would leave it behind."""

from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
CORE = yaml.safe_load((ROOT / "tools" / "core_mutants.yaml").read_text(encoding="utf-8"))
PARTS = yaml.safe_load((ROOT / "tools" / "mutants.yaml").read_text(encoding="utf-8"))["parts"]


@pytest.mark.parametrize("folder", CORE["mutants"])
def test_the_line_of_each_mutant_is_there_once(folder):
    for mutant in CORE["mutants"][folder]:
        text = (ROOT / "src" / folder / mutant["file"]).read_text(encoding="utf-8")
        assert text.count(mutant["old"]) == 1, mutant["about"]
        assert mutant["test"] in CORE["tests"]


@pytest.mark.parametrize("part", PARTS)
def test_the_modules_of_each_part_and_its_tests_are_there(part):
    named = PARTS[part]
    package = ROOT / "src" / named["package"]
    for module in named["modules"]:
        assert (package / "src" / named["package"] / module).is_file(), module
    for test in named["tests"]:
        assert (package / "test" / test).is_file(), test
