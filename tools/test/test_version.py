"""One version everywhere, and releases that are refused or complete."""

import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FORTHCOMING = "Forthcoming\n  * A feature.\n\n0.2.0 (2026-11-22)\n  * An older one.\n"
MANIFEST = "<package>\n  <version>0.3.0</version>\n</package>\n"


def run(folder, *command):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


@pytest.fixture
def project(tmp_path):
    """Return a repository with a package, the tools, and a make that leaves wheels."""
    for name in ("version", "release"):
        add(tmp_path, f"tools/{name}", (ROOT / "tools" / name).read_text(), 0o755)
    add(tmp_path, "VERSION", "0.3.0\n")
    add(tmp_path, "CITATION.cff", "version: 0.3.0\n")
    add(tmp_path, "CHANGELOG", FORTHCOMING)
    add(tmp_path, "src/a/package.xml", MANIFEST)
    add(tmp_path, "src/a/CHANGELOG.rst", "Forthcoming\n-----------\n* A feature.\n")
    add(tmp_path, ".gitignore", "/bin/\n/results/\n")
    wheels = "results/f1tenth_sim2d-0.3.0-py3-none-any.whl results/f1tenth_judge-0.3.0-py3-none-any.whl"
    add(tmp_path, "bin/make", f"#!/bin/sh\nmkdir -p results; touch {wheels}\n", 0o755)
    run(tmp_path, "git", "init", "-q")
    commit(tmp_path)
    return tmp_path


def add(folder, name, text, mode=0o644):
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(mode)


def commit(folder):
    run(folder, "git", "config", "user.name", "someone")
    run(folder, "git", "config", "user.email", "someone@example.org")
    run(folder, "git", "add", "-A")
    assert run(folder, "git", "commit", "-qm", "Begin").returncode == 0


def release(project):
    return run(project, "bash", "-c", 'PATH="$PWD/bin:$PATH" tools/release')


def test_the_workspace_has_one_version():
    assert run(ROOT, "tools/version").stderr == ""


def test_another_version_is_named_with_its_file(project):
    add(project, "src/a/package.xml", MANIFEST.replace("0.3.0", "0.2.0"))
    found = run(project, "tools/version")
    assert found.returncode == 1
    assert found.stderr == "src/a/package.xml: version: found 0.2.0, must be 0.3.0, that of VERSION\n"


def test_it_is_set_everywhere(project):
    assert run(project, "tools/version", "0.4.0").returncode == 0
    assert run(project, "tools/version").returncode == 0
    assert "<version>0.4.0</version>" in (project / "src/a/package.xml").read_text()


def test_a_release_dates_the_changelogs_and_is_tagged(project):
    done = release(project)
    assert done.returncode == 0, done.stderr
    assert (project / "CHANGELOG").read_text().startswith("0.3.0 (20")
    title, line, *_ = (project / "src/a/CHANGELOG.rst").read_text().splitlines()
    assert title.startswith("0.3.0 (20")
    assert line == "-" * len(title)
    assert "A feature." in run(project, "git", "tag", "-n9", "-l", "v0.3.0").stdout
    assert run(project, "git", "status", "--porcelain").stdout == ""


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("notes", "", "there are changes that are not committed"),
        ("VERSION", "0.4.0\n", "set one version everywhere: tools/version 0.4.0"),
    ],
)
def test_a_release_of_what_is_not_ready_is_refused(project, name, text, message):
    add(project, name, text)
    done = release(project)
    assert done.returncode == 1
    assert message in done.stderr


def test_a_release_is_not_made_twice(project):
    assert release(project).returncode == 0
    assert "v0.3.0 exists: tools/version NEXT" in release(project).stderr
