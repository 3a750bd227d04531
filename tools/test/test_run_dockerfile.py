import importlib.machinery
import importlib.util
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LOADER = importlib.machinery.SourceFileLoader("run_dockerfile", str(ROOT / "tools" / "run_dockerfile"))
run_dockerfile = importlib.util.module_from_spec(importlib.util.spec_from_loader("run_dockerfile", LOADER))
LOADER.exec_module(run_dockerfile)

TEXT = """# comment
FROM debian AS one
RUN a && \\
    b
FROM one AS two
COPY . .
"""


def test_continued_lines_are_one_step():
    assert run_dockerfile.steps_of(TEXT)[1] == ("RUN", "a &&      b")


def test_steps_end_with_the_target():
    steps = run_dockerfile.steps_of(TEXT)
    assert [step for step, _ in run_dockerfile.steps_until(steps, "one")] == ["RUN"]
    assert [step for step, _ in run_dockerfile.steps_until(steps, None)] == ["RUN", "COPY"]


@pytest.mark.parametrize(
    ("text", "target", "message"),
    [
        (TEXT, "three", "--target three: no such stage"),
        (
            TEXT.replace("FROM one", "FROM debian"),
            None,
            "FROM debian AS two: expected the stage before it, one",
        ),
    ],
)
def test_what_cannot_be_carried_out_is_refused(text, target, message):
    with pytest.raises(run_dockerfile.UnknownStep, match=f"^{message}$"):
        run_dockerfile.steps_until(run_dockerfile.steps_of(text), target)


def test_an_unknown_step_is_refused(tmp_path):
    with pytest.raises(run_dockerfile.UnknownStep, match="^HEALTHCHECK: known are FROM, RUN"):
        run_dockerfile.Folder(tmp_path, tmp_path).do("HEALTHCHECK", "NONE")


def test_each_stage_of_the_workspace_can_be_carried_out():
    steps = run_dockerfile.steps_of((ROOT / "Dockerfile").read_text())
    build = run_dockerfile.steps_until(steps, "build")
    assert ("RUN", "make build UNITY=ON") in build
    assert ("RUN", "tools/setup --tests") not in build
    assert ("RUN", "tools/setup --tests") in run_dockerfile.steps_until(steps, "test")


def test_files_are_copied(tmp_path):
    run_dockerfile.Folder(tmp_path, ROOT).do("COPY", "setup setup")
    assert (tmp_path / "setup" / "debian-packages.txt").read_text().startswith("# Packages of Debian")
