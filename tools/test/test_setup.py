import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def write_command(folder, name, script):
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)


@pytest.fixture
def machine(tmp_path):
    """Return a PATH on which nothing is installed yet, with nobody's rights and no sudo."""
    for name in ("bash", "cat", "sed", "sort", "comm", "dirname", "env", "grep", "ln", "rm"):
        (tmp_path / name).symlink_to(f"/usr/bin/{name}")
    write_command(tmp_path, "dpkg-query", "exit 0")
    write_command(tmp_path, "id", "echo 1000")
    # The Python of the virtual environment: what is missing is asked first, then pip is called.
    write_command(tmp_path / "venv" / "bin", "python3", f'[ "$1" = - ] || echo "$*" >> {tmp_path}/pip')
    return tmp_path


def add_sudo(machine):
    write_command(machine, "sudo", f'echo "sudo $*" >> {machine}/sudo_calls')


def run_setup(machine, *arguments):
    environment = {**os.environ, "PATH": str(machine), "F1TENTH_VENV": str(machine / "venv")}
    return subprocess.run(
        [ROOT / "tools" / "setup", *arguments],
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )


RELEASE = re.search('VERSION_ID="(.*)"', Path("/etc/os-release").read_text())[1]


def names_in(name):
    """Packages of this release."""
    text = (ROOT / "setup" / name).read_text()
    lines = [line.split() for line in text.splitlines() if line and not line.startswith("#")]
    return [name for name, *release in lines if release in ([], [f"@{RELEASE}"])]


def install(machine, *names):
    listing = "\\n".join(f"ii  {name}" for name in names)
    write_command(machine, "dpkg-query", f"printf '{listing}\\n'")


def test_packages_of_another_release_are_left_alone(machine):
    lines = (ROOT / "setup" / "debian-packages.txt").read_text().splitlines()
    of_one_release = [line.split() for line in lines if " @" in line and not line.startswith("#")]
    asked_for = run_setup(machine).stderr.split()
    assert "@12" not in asked_for
    assert all((name in asked_for) is (wanted == f"@{RELEASE}") for name, wanted in of_one_release)


def test_without_root_and_sudo_it_says_which_packages_to_install(machine):
    result = run_setup(machine)
    assert result.returncode == 1
    assert "neither root nor sudo" in result.stderr
    assert "apt-get install" in result.stderr
    assert "libbox2d-dev" in result.stderr


def test_sudo_is_not_used_without_asking(machine):
    add_sudo(machine)
    result = run_setup(machine)
    assert result.returncode == 1
    assert "setup: from Debian: " in result.stdout
    assert "libbox2d-dev" in result.stdout
    assert "Allow it with: tools/setup --yes" in result.stderr
    assert not (machine / "sudo_calls").exists()


def test_sudo_is_used_when_it_was_allowed(machine):
    add_sudo(machine)
    result = run_setup(machine, "--yes")
    assert result.returncode == 0, result.stderr
    calls = (machine / "sudo_calls").read_text()
    assert "sudo apt-get update" in calls
    assert "libbox2d-dev" in calls


def test_root_needs_no_sudo(machine):
    write_command(machine, "id", "echo 0")
    write_command(machine, "apt-get", f'echo "$*" >> {machine}/apt_calls')
    result = run_setup(machine)
    assert result.returncode == 0, result.stderr
    assert "libbox2d-dev" in (machine / "apt_calls").read_text()


def test_what_comes_from_pypi_goes_into_the_virtual_environment_without_root(machine):
    install(machine, *names_in("debian-packages.txt"))
    python = f'[ "$1" = - ] && echo xacro==1.13.3 || echo "$*" >> {machine}/pip'
    write_command(machine / "venv" / "bin", "python3", python)
    result = run_setup(machine)
    assert result.returncode == 0, result.stderr
    assert f"from PyPI, into {machine / 'venv'}: xacro==1.13.3" in result.stdout
    assert (machine / "pip").read_text().startswith("-m pip install ")
    assert "break-system-packages" not in (machine / "pip").read_text()


def test_on_another_system_it_says_what_is_needed(machine):
    (machine / "dpkg-query").unlink()
    result = run_setup(machine)
    assert result.returncode == 1
    assert "not a Debian system" in result.stderr


def test_nothing_is_installed_when_nothing_is_missing(machine):
    install(machine, *names_in("debian-packages.txt"))
    add_sudo(machine)
    result = run_setup(machine)
    assert result.returncode == 0, result.stderr
    assert result.stdout == ""
    assert not (machine / "sudo_calls").exists()
    assert not (machine / "pip").exists()


def test_what_only_tests_need_is_installed_when_asked_for(machine):
    install(machine, *names_in("debian-packages.txt"))
    result = run_setup(machine, "--tests")
    assert result.returncode == 1
    assert set(names_in("debian-test-packages.txt")) <= set(result.stderr.split())
    assert "libbox2d-dev" not in result.stderr
    assert {"nodejs", "npm"} <= set(result.stderr.split())


def test_what_comes_from_npm_goes_into_the_virtual_environment(machine):
    install(machine, *names_in("debian-packages.txt"), *names_in("debian-test-packages.txt"))
    write_command(machine, "npm", f'echo "$*" >> {machine}/npm_calls')
    result = run_setup(machine, "--tests")
    assert result.returncode == 0, result.stderr
    tools = machine / "venv" / "web-tools"
    assert f"from npm, into {tools}: {' '.join(names_in('npm-test-packages.txt'))}" in result.stdout
    assert f"--prefix {tools} " in (machine / "npm_calls").read_text()


def test_another_argument_is_refused(machine):
    result = run_setup(machine, "--test")
    assert result.returncode == 2
    assert "found '--test', allowed: --docs, --tests, --yes" in result.stderr
