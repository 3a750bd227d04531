"""What a run leaves of the one before it."""

import json

import pytest
from f1tenth_scenarios.results.results_folder import claimed


def run(folder, commit, seed):
    with claimed(folder, folder / "log", commit):
        assert not (folder / "result.json").exists()
        content = {"seed": seed, "versions": {"commit": commit}}
        (folder / "result.json").write_text(json.dumps(content), encoding="utf-8")
        (folder / "trajectory.csv").write_text(str(seed), encoding="utf-8")


def seed_of(folder):
    return json.loads((folder / "result.json").read_text(encoding="utf-8"))["seed"]


def test_results_of_another_commit_are_kept(tmp_path):
    run(tmp_path, "a", 1)
    run(tmp_path, "b", 2)
    assert (seed_of(tmp_path), seed_of(tmp_path / "previous")) == (2, 1)
    assert (tmp_path / "previous" / "trajectory.csv").read_text(encoding="utf-8") == "1"


def test_results_of_the_same_commit_are_not(tmp_path):
    run(tmp_path, "a", 1)
    run(tmp_path, "b", 2)
    run(tmp_path, "b", 3)
    assert (seed_of(tmp_path), seed_of(tmp_path / "previous")) == (3, 1)


@pytest.mark.parametrize("commit", ["a-dirty", None])
def test_results_of_unknown_changes_are_kept(tmp_path, commit):
    run(tmp_path, commit, 1)
    run(tmp_path, commit, 2)
    assert seed_of(tmp_path / "previous") == 1


def test_result_that_cannot_be_read_is_kept_too(tmp_path):
    (tmp_path / "result.json").write_text("nonsense", encoding="utf-8")
    run(tmp_path, "a", 1)
    assert (tmp_path / "previous" / "result.json").read_text(encoding="utf-8") == "nonsense"


def test_only_one_run_before_is_kept(tmp_path):
    (tmp_path / "previous").mkdir()
    (tmp_path / "previous" / "trajectory.png").touch()
    run(tmp_path, "a", 1)
    run(tmp_path, "b", 2)
    assert not (tmp_path / "previous" / "trajectory.png").exists()
