import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize(
    ("name", "schema"),
    [
        (".github/workflows/ci.yml", ["--builtin-schema", "vendor.github-workflows"]),
        (".gitlab-ci.yml", ["--builtin-schema", "vendor.gitlab-ci", "--data-transform", "gitlab-ci"]),
    ],
)
def test_ci_file_keeps_its_schema_and_runs_what_all_run(name, schema):
    command = [sys.executable, "-m", "check_jsonschema", *schema, str(ROOT / name)]
    checked = subprocess.run(command, capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout + checked.stderr
    assert ".ci/run\n" in (ROOT / name).read_text()
