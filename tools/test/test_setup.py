import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def write_command(folder, name, script):
    path = folder / name
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)


@pytest.fixture
def machine(tmp_path):
    """Return a PATH on which nothing is installed yet, with nobody's rights and no sudo."""
    for name in ("bash", "sed", "sort", "comm", "dirname", "env"):
        (tmp_path / name).symlink_to(f"/usr/bin/{name}")
    write_command(tmp_path, "dpkg-query", "exit 0")
    write_command(tmp_path, "id", "echo 1000")
    return tmp_path


def run_setup(machine, *arguments):
    environment = {**os.environ, "PATH": str(machine)}
    return subprocess.run(
        [ROOT / "tools" / "setup", *arguments], env=environment, capture_output=True, text=True, check=False
    )


def names_in(name):
    text = (ROOT / "setup" / name).read_text()
    return [line for line in text.splitlines() if line and not line.startswith("#")]


def install(machine, *names):
    listing = "\\n".join(f"ii  {name}" for name in names)
    write_command(machine, "dpkg-query", f"printf '{listing}\\n'")


def test_without_root_and_sudo_it_says_which_packages_to_install(machine):
    result = run_setup(machine)
    assert result.returncode == 1
    assert "neither root nor sudo" in result.stderr
    assert "apt-get install" in result.stderr
    assert "libbox2d-dev" in result.stderr


def test_without_root_it_uses_sudo(machine):
    write_command(machine, "sudo", f'echo "sudo $*" >> {machine}/calls; exit 0')
    run_setup(machine)
    calls = (machine / "calls").read_text()
    assert "sudo apt-get update" in calls
    assert "libbox2d-dev" in calls


def test_on_another_system_it_says_what_is_needed(machine):
    (machine / "dpkg-query").unlink()
    result = run_setup(machine)
    assert result.returncode == 1
    assert "not a Debian system" in result.stderr


def test_nothing_is_installed_when_nothing_is_missing(machine):
    install(machine, *names_in("debian-packages.txt"))
    write_command(machine, "sudo", f"touch {machine}/called")
    result = run_setup(machine)
    assert result.returncode == 0, result.stderr
    assert not (machine / "called").exists()


def test_what_only_tests_need_is_installed_when_asked_for(machine):
    install(machine, *names_in("debian-packages.txt"))
    result = run_setup(machine, "--tests")
    assert result.returncode == 1
    assert set(names_in("debian-test-packages.txt")) <= set(result.stderr.split())
    assert "libbox2d-dev" not in result.stderr


def test_another_argument_is_refused(machine):
    result = run_setup(machine, "--test")
    assert result.returncode == 2
    assert "found '--test', allowed: nothing, or --tests" in result.stderr
