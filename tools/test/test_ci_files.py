import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


GITHUB = ["--builtin-schema", "vendor.github-workflows"]
GITLAB = ["--builtin-schema", "vendor.gitlab-ci", "--data-transform", "gitlab-ci"]
TEMPLATE = "templates/planner_package"


@pytest.mark.parametrize(
    ("name", "schema", "command"),
    [
        (".github/workflows/ci.yml", GITHUB, ".ci/run ${{ matrix.stage }}"),
        (".github/workflows/nightly.yml", GITHUB, "run: ${{ matrix.command }}"),
        (".github/workflows/release.yml", GITHUB, "tools/make_wheel build/wheel results python3"),
        (".gitlab-ci.yml", GITLAB, ".ci/run $STAGE"),
        (f"{TEMPLATE}/.github/workflows/planner.yml", GITHUB, "ci/test"),
        (f"{TEMPLATE}/.gitlab-ci.yml", GITLAB, "ci/test"),
    ],
)
def test_ci_file_keeps_its_schema_and_runs_what_all_run(name, schema, command):
    checker = [sys.executable, "-m", "check_jsonschema", *schema, str(ROOT / name)]
    checked = subprocess.run(checker, capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout + checked.stderr
    assert f"{command}\n" in (ROOT / name).read_text()
