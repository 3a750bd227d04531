"""What the mutants of tools/*mutants.yaml name is there: a change of the code would leave it behind."""

import importlib.machinery
import importlib.util
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
LOADER = importlib.machinery.SourceFileLoader("core_mutants", str(ROOT / "tools" / "core_mutants"))
core_mutants = importlib.util.module_from_spec(importlib.util.spec_from_loader("core_mutants", LOADER))
LOADER.exec_module(core_mutants)
TESTS, MUTANTS = core_mutants._read(ROOT / "tools" / "core_mutants.yaml")
PARTS = yaml.safe_load((ROOT / "tools" / "mutants.yaml").read_text(encoding="utf-8"))["parts"]


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda each: each.about)
def test_the_line_of_each_mutant_is_there_once(mutant):
    core_mutants._place(core_mutants.Workspace(ROOT), mutant)  # ends with what is wrong
    assert mutant.test in TESTS


@pytest.mark.parametrize("part", PARTS)
def test_the_modules_of_each_part_and_its_tests_are_there(part):
    named = PARTS[part]
    package = ROOT / "src" / named["package"]
    for module in named["modules"]:
        assert (package / "src" / named["package"] / module).is_file(), module
    for test in named["tests"]:
        assert (package / "test" / test).is_file(), test
