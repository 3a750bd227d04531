"""Which commit a result was made with."""

import subprocess

import pytest
from f1tenth_judge.results import versions


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "ours").mkdir()
    monkeypatch.setattr("f1tenth_judge.places.packages.package_path", lambda _: tmp_path / "ours")
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path.parent))
    return tmp_path / "ours"


def commit():
    return versions.commits({})["commit"]


def git(folder, *arguments):
    who = ["-c", "user.name=a", "-c", "user.email=a@b"]
    done = subprocess.run(["git", "-C", folder, *who, *arguments], capture_output=True, text=True, check=True)
    return done.stdout.strip()


def make_commit(folder):
    git(folder, "init", "-q")
    (folder / "a").write_text("a", encoding="utf-8")
    git(folder, "add", "a")
    git(folder, "commit", "-qm", "a")
    return git(folder, "rev-parse", "HEAD")[:12]


def test_commit_is_that_of_the_workspace(folder):
    made = make_commit(folder)
    assert commit() == made


def test_changes_since_the_commit_are_told(folder):
    made = make_commit(folder)
    (folder / "a").write_text("b", encoding="utf-8")
    assert commit() == f"{made}-dirty"


def test_outside_of_git_there_is_no_commit(folder):
    assert commit() is None


def test_without_git_there_is_no_commit(folder, monkeypatch):
    make_commit(folder)
    monkeypatch.setenv("PATH", str(folder))
    assert commit() is None


def test_commits_of_drivers_are_those_of_their_folders(folder):
    mine = folder.parent / "mine"
    (mine / "launch").mkdir(parents=True)
    made = make_commit(mine)
    drivers = {"robot1": mine / "launch", "robot2": folder}
    assert versions.commits(drivers) == {"commit": None, "driver_commits": {"robot1": made, "robot2": None}}
    assert versions.collect(drivers)["driver_commits"]["robot1"] == made
