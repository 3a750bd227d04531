"""A file of tests that no CMakeLists.txt names is never run, and nobody notices."""

import re
from pathlib import PurePosixPath

import pytest
from package_edges import packages, tracked_files

_DEFAULTS = ("test/test_*.py", "test/*/test_*.py")


def is_test(path):
    """Whether it holds tests, by its name and its folder in the package."""
    return "test" in path.parts and (
        path.match("test_*.py") or path.name.endswith(("_test.cpp", ".test", "_test.py"))
    )


def is_run(path, listings):
    """Whether a CMakeLists.txt of its package names it, or has a pattern that it matches.

    Args:
        path: of the file.
        listings: {folder: text of its CMakeLists.txt}.
    """
    for folder, text in listings.items():
        if folder not in path.parents:
            continue
        patterns = re.findall(r"[\w./*-]*\*[\w./*-]*", text)
        if re.search(r"workspace_add_pytest\((\)|EXCLUDE)", text):
            patterns += _DEFAULTS
        relative = path.relative_to(folder)
        if re.search(rf"\b{path.stem}\b", text) or any(fits(relative, pattern) for pattern in patterns):
            return True
    return False


def fits(path, pattern):
    """Whether a pattern of CMake's file(GLOB), in which `*` is within a folder, matches a whole path."""
    wanted = PurePosixPath(pattern)
    return len(path.parts) == len(wanted.parts) and path.match(pattern)


@pytest.mark.parametrize("package", sorted(packages().values()), ids=lambda folder: folder.name)
def test_every_file_of_tests_is_run(package):
    files = tracked_files(package)
    listings = {path.parent: path.read_text() for path in files if path.name == "CMakeLists.txt"}
    launched = "".join(path.read_text() for path in files if path.suffix == ".test")
    tests = [path for path in files if is_test(path.relative_to(package))]
    assert [
        str(path) for path in tests if f'"{path.name}"' not in launched and not is_run(path, listings)
    ] == []


@pytest.mark.parametrize(
    ("text", "name", "run"),
    [
        ("workspace_add_pytest()", "test/test_a.py", True),
        ("workspace_add_pytest(EXCLUDE /slow/)", "test/b/test_a.py", True),
        ("workspace_add_pytest()", "test/b/c/test_a.py", False),
        ("workspace_add_pytest(NAME b test/b/test_*.py)", "test/b/test_a.py", True),
        ("workspace_add_pytest(NAME b test/b/test_*.py)", "test/test_a.py", False),
        ("catkin_add_gtest(all test/a_test.cpp)", "test/a_test.cpp", True),
        ("catkin_add_gtest(all test/aa_test.cpp)", "test/a_test.cpp", False),
        ("file(GLOB ros_tests test/*/*.test)", "test/b/a.test", True),
    ],
)
def test_what_is_not_run_is_found(text, name, run):
    folder = PurePosixPath("src/package")
    assert is_test(PurePosixPath(name))
    assert is_run(folder / name, {folder: text}) == run
