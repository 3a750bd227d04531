"""The template of a package, copied to an empty folder: what its CI files say is run, step by step."""

import json
import os
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
import yaml
from patience import PATIENCE

ROOT = Path(__file__).parents[4]
TEMPLATE = ROOT / "templates" / "planner_package"
SCENARIOS = ("my_lap", "my_race")
IMAGE_ONLY = "apt-get "  # steps that are for a machine which has nothing yet
NOTHING_YET = "no results of the main branch yet"


@pytest.fixture(scope="module")
def repository(tmp_path_factory):
    """A copy of the template, beside a repository in the place of the workspace, which is built."""
    folder = tmp_path_factory.mktemp("somewhere") / "my_repository"
    shutil.copytree(TEMPLATE, folder)
    published = folder.parent / "published"
    published.mkdir()
    (published / "Makefile").write_text("build:\n\t@echo built\n", encoding="utf-8")
    (published / "devel").symlink_to(os.environ["CMAKE_PREFIX_PATH"].split(os.pathsep)[0])
    who = ["-c", "user.name=test", "-c", "user.email=test@localhost"]
    for command in (["init", "-q"], ["add", "."], [*who, "commit", "-qm", "The workspace"]):
        subprocess.run(["git", "-C", published, *command], check=True)
    return folder


def execute(repository, command, **variables):
    """Runs a command as a CI does, in an environment that knows nothing of ROS; returns what it says."""
    environment = {
        "PATH": "/usr/bin:/bin:/usr/local/bin",
        "HOME": os.environ["HOME"],
        "F1TENTH_WORKSPACE_URL": str(repository.parent / "published"),
        "F1TENTH_WORKSPACE_REF": "HEAD",
        "GITHUB_OUTPUT": os.devnull,
        **variables,
    }
    done = subprocess.run(
        ["bash", "-ec", command],
        cwd=repository,
        env=environment,
        capture_output=True,
        text=True,
        timeout=3 * PATIENCE,
    )
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


def results(repository):
    files = [repository / "results" / name / "result.json" for name in SCENARIOS]
    return [json.loads(file.read_text(encoding="utf-8")) for file in files]


def test_steps_for_github_judge_the_planner_and_compare(repository):
    workflow = yaml.safe_load((TEMPLATE / ".github/workflows/planner.yml").read_text(encoding="utf-8"))
    steps = [each["run"] for each in workflow["jobs"]["scenarios"]["steps"] if "run" in each]
    said = [execute(repository, step) for step in steps if not step.startswith(IMAGE_ONLY)]
    assert any(NOTHING_YET in each for each in said)
    assert [each["verdict"] for each in results(repository)] == ["success", "success"]
    assert (repository / "results" / "report.html").read_text(encoding="utf-8").startswith("<!doctype html>")
    suite = ElementTree.parse(repository / "results" / "junit.xml").getroot()
    names = {each.get("name") for each in suite.iter("testcase")}
    assert names == {*SCENARIOS, *(f"test_a_lap_without_drama[{kind}]" for kind in ("node", "class"))}
    assert not [*suite.iter("failure"), *suite.iter("skipped")]


def test_steps_for_gitlab_find_that_nothing_has_become_worse(repository):
    hashes = [each["trajectory_hash"] for each in results(repository)]
    steps = yaml.safe_load((TEMPLATE / ".gitlab-ci.yml").read_text(encoding="utf-8"))["scenarios"]["script"]
    said = [execute(repository, step, CI_COMMIT_BRANCH="main", CI_DEFAULT_BRANCH="main") for step in steps]
    assert "0 of 4 scenarios became worse" in said[2]
    assert len(ElementTree.parse(repository / "compare.xml").getroot().findall("testcase")) == 4
    assert [each["trajectory_hash"] for each in results(repository)] == hashes


def test_scenario_is_a_rostest_as_well(repository):
    said = execute(
        repository,
        "source overlay/devel/setup.bash && rostest planner_package my_lap.test",
        F1TENTH_RESULTS="rostest",
    )
    assert "RESULT: SUCCESS" in said


def test_make_race_finds_the_planner_in_the_overlay_that_is_sourced(repository):
    out = (repository / "workspace" / "devel").resolve().parent
    race = f'race OUT="{out}" PLANNER="$PWD/launch/planner.launch"'
    said = execute(
        repository,
        f'source overlay/devel/setup.bash && make -C "{ROOT}" -o build {race}',
        F1TENTH_RESULTS=str(repository / "raced"),
    )
    assert "reason:            every lap was driven" in said
