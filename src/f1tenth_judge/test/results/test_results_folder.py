"""What a run leaves of the one before it."""

import json

import pytest
from f1tenth_judge.results.results_folder import claimed

COMMITS = {"commit": "a", "driver_commits": {}}


def run(folder, commit, seed, driver="a"):
    commits = {"commit": commit, "driver_commits": {"robot1": driver}}
    with claimed(folder, folder / "log", commits) as claim:
        assert list((folder / "log").iterdir()) == []
        (folder / "log" / "seed").write_text(str(seed), encoding="utf-8")
        place = claim.place_of_results()
        assert place == folder
        assert not (folder / "result.json").exists()
        content = {"seed": seed, "versions": {**commits, "python": "3"}}
        (place / "result.json").write_text(json.dumps(content), encoding="utf-8")
        (place / "trajectory.csv").write_text(str(seed), encoding="utf-8")


def seed_of(folder):
    return json.loads((folder / "result.json").read_text(encoding="utf-8"))["seed"]


def log_of(folder):
    return (folder / "log" / "seed").read_text(encoding="utf-8")


def test_results_of_another_commit_are_kept(tmp_path):
    run(tmp_path, "a", 1)
    run(tmp_path, "b", 2)
    assert (seed_of(tmp_path), seed_of(tmp_path / "previous")) == (2, 1)
    assert (tmp_path / "previous" / "trajectory.csv").read_text(encoding="utf-8") == "1"
    assert log_of(tmp_path) == "2"
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        ".lock", "log", "previous", "result.json", "trajectory.csv",
    ]  # fmt: skip


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


@pytest.mark.parametrize("driver", ["b", "a-dirty", None])
def test_results_of_another_commit_of_a_driver_are_kept(tmp_path, driver):
    run(tmp_path, "a", 1, driver)
    run(tmp_path, "a", 2, "a")
    assert seed_of(tmp_path / "previous") == 1


def test_results_that_name_no_commits_of_drivers_are_kept(tmp_path):
    run(tmp_path, "a", 1)
    (tmp_path / "result.json").write_text('{"seed": 1, "versions": {"commit": "a"}}', encoding="utf-8")
    run(tmp_path, "a", 2)
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


def interrupt(folder, seed):
    with claimed(folder, folder / "log", COMMITS) as claim:
        (folder / "log" / "seed").write_text(str(seed), encoding="utf-8")
        place = claim.place_of_interrupted()
        (place / "result.json").write_text(json.dumps({"seed": seed}), encoding="utf-8")


def test_interrupted_run_leaves_what_was_there(tmp_path):
    run(tmp_path, "a", 1)
    for seed in (2, 3):
        interrupt(tmp_path, seed)
        assert (seed_of(tmp_path), log_of(tmp_path)) == (1, "1")
        assert (seed_of(tmp_path / "interrupted"), log_of(tmp_path / "interrupted")) == (seed, str(seed))


def test_interrupted_first_run_leaves_nothing_else(tmp_path):
    interrupt(tmp_path, 1)
    assert sorted(path.name for path in tmp_path.iterdir()) == [".lock", "interrupted"]


def break_off(folder, seed):
    with claimed(folder, folder / "log", COMMITS):
        (folder / "log" / "seed").write_text(str(seed), encoding="utf-8")
        raise RuntimeError


def test_run_that_breaks_leaves_its_log_aside(tmp_path):
    run(tmp_path, "a", 1)
    with pytest.raises(RuntimeError):
        break_off(tmp_path, 2)
    assert (seed_of(tmp_path), log_of(tmp_path), log_of(tmp_path / "interrupted")) == (1, "1", "2")


def test_log_of_a_run_that_was_killed_does_not_take_the_place_of_an_earlier_one(tmp_path):
    run(tmp_path, "a", 1)
    (tmp_path / "log").rename(tmp_path / ".earlier_log")
    (tmp_path / "log").mkdir()
    (tmp_path / "log" / "seed").write_text("2", encoding="utf-8")
    interrupt(tmp_path, 3)
    assert (seed_of(tmp_path), log_of(tmp_path)) == (1, "1")


@pytest.mark.parametrize("is_killed", [False, True])
@pytest.mark.parametrize("driver", ["a", "b"])
def test_results_come_back_with_their_log_if_new_ones_cannot_be_written(tmp_path, is_killed, driver):
    run(tmp_path, "a", 1)
    commits = {"commit": "a", "driver_commits": {"robot1": driver}}
    with claimed(tmp_path, tmp_path / "log", commits) as claim:
        (tmp_path / "log" / "seed").write_text("2", encoding="utf-8")
        place = claim.place_of_results()
        assert not (place / "trajectory.csv").exists()
        claim.close = (lambda: None) if is_killed else claim.close
    if is_killed:
        interrupt(tmp_path, 2)
    assert (seed_of(tmp_path), log_of(tmp_path), log_of(tmp_path / "interrupted")) == (1, "1", "2")
    assert (tmp_path / "trajectory.csv").read_text(encoding="utf-8") == "1"
    assert not list(tmp_path.glob(".earlier*"))


def test_run_that_is_killed_when_its_result_is_written_has_its_own_log(tmp_path):
    run(tmp_path, "a", 1)
    with claimed(tmp_path, tmp_path / "log", {"commit": "b", "driver_commits": {}}) as claim:
        (tmp_path / "log" / "seed").write_text("2", encoding="utf-8")
        (claim.place_of_results() / "result.json").write_text('{"seed": 2}', encoding="utf-8")
        claim.close = lambda: None
    interrupt(tmp_path, 3)
    assert (seed_of(tmp_path), log_of(tmp_path), seed_of(tmp_path / "previous")) == (2, "2", 1)
