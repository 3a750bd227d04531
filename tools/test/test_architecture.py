"""docs/architecture.md shows who uses whom, and arrows between folders run one way only."""

import functools
import graphlib
import re
import subprocess

import package_edges
import pytest
from package_edges import ROOT, code_edges, manifest_edges, packages
from room_edges import circle, sibling_graphs

DOCUMENT = ROOT / "docs" / "architecture.md"
USES = "## Who may use whom"
TESTS_USE = "### In tests besides"
# Everything may use these.
COMMON = {"ackermann_msgs", "controller_manager_msgs", "gazebo_msgs", "workspace_cmake"}


def shown_edges(heading):
    """Pairs (user, used) of the lines `user -> used, used` below a heading of the document."""
    section = DOCUMENT.read_text(encoding="utf-8").split(f"{heading}\n")[1]
    section = re.split(r"^#", section, maxsplit=1, flags=re.MULTILINE)[0]
    lines = re.findall(r"^ {4}(\S+) +-> (.+)$", section, re.MULTILINE)
    assert lines, f"{DOCUMENT.name}: no arrows below {heading}"
    return {(user, used.strip()) for user, targets in lines for used in targets.split(",")}


@functools.lru_cache(maxsize=1)
def edges_in_code():
    """The edges of includes, imports and launch files: reading all files takes seconds."""
    return list(code_edges())


def edges():
    """Edges of manifests and code, without those to what everything may use."""
    return [edge for edge in [*manifest_edges(), *edges_in_code()] if edge.used not in COMMON]


def described(found):
    """The edges as a person reads them, one file each."""
    files = {(edge.user, edge.used): edge.where for edge in found}
    return [f"{user} -> {used} ({where})" for (user, used), where in sorted(files.items())]


def test_every_edge_is_shown():
    shown = shown_edges(USES)
    hidden = [edge for edge in edges() if not edge.in_tests and (edge.user, edge.used) not in shown]
    assert described(hidden) == []


def test_every_edge_of_tests_is_shown():
    shown = shown_edges(USES) | shown_edges(TESTS_USE)
    hidden = [edge for edge in edges() if edge.in_tests and (edge.user, edge.used) not in shown]
    assert described(hidden) == []


def test_nothing_is_shown_that_is_not_there():
    product = {(edge.user, edge.used) for edge in edges() if not edge.in_tests}
    tests = {(edge.user, edge.used) for edge in edges() if edge.in_tests}
    assert sorted(shown_edges(USES) - product) == []
    assert sorted(shown_edges(TESTS_USE) - tests) == []
    assert sorted(shown_edges(TESTS_USE) & product) == []


def test_every_edge_of_code_is_declared_in_its_manifest():
    declared = {(edge.user, edge.used) for edge in manifest_edges() if not edge.in_tests}
    declared_in_tests = declared | {(edge.user, edge.used) for edge in manifest_edges()}
    undeclared = [
        edge
        for edge in edges_in_code()
        if (edge.user, edge.used) not in (declared_in_tests if edge.in_tests else declared)
    ]
    assert described(undeclared) == []


def test_packages_do_not_use_each_other_in_a_circle():
    graph = {}
    for user, used in shown_edges(USES):
        graph.setdefault(user, set()).add(used)
    graphlib.TopologicalSorter(graph).prepare()


@pytest.mark.parametrize("name", sorted(packages()))
def test_arrows_between_folders_run_one_way(name):
    found = {}
    for folder, graph in sibling_graphs(packages()[name]).items():
        around = circle(graph)
        if around:
            found[name, folder] = [graph[user][used] for user, used in zip(around, around[1:])]
    assert found == {}


def test_every_package_is_described():
    table = DOCUMENT.read_text(encoding="utf-8").split(USES)[0]
    missing = [
        name
        for name, folder in packages().items()
        if folder.parent.name != "standins" and f"| `{name}` |" not in table
    ]
    assert missing == []


def add(folder, files):
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


@pytest.mark.parametrize(
    ("files", "folder", "around"),
    [
        (
            {
                "src/a/one.cpp": '#include "b/two.h"',
                "src/b/two.h": "",
                "src/b/three.h": '#include "../a/four.h"',
                "src/a/four.h": "",
            },
            "src",
            {"src/a", "src/b"},
        ),
        (
            {
                "src/p/__init__.py": "",
                "src/p/top.py": "from p.room import low",
                "src/p/room/low.py": "import p.top",
            },
            "src/p",
            {"src/p/top.py", "src/p/room"},
        ),
    ],
)
def test_a_circle_of_folders_is_found(tmp_path, files, folder, around):
    subprocess.run(["git", "init", "-q", tmp_path], check=True)
    add(tmp_path, files)
    assert set(circle(sibling_graphs(tmp_path)[folder])) == around


def test_a_package_that_includes_finds_and_imports_another_uses_it(tmp_path, monkeypatch):
    subprocess.run(["git", "init", "-q", tmp_path], check=True)
    for name in ("user", "cpp", "module", "place"):
        add(tmp_path / "src" / name, {"package.xml": f"<package><name>{name}</name></package>"})
    add(
        tmp_path / "src" / "user",
        {
            "src/a.cpp": "#include <cpp/b.h>",
            "scripts/run": "#!/usr/bin/env python3\nfrom module.c import d",
            "test/e.launch": '<include file="$(find place)/f.launch"/>',
        },
    )
    monkeypatch.setattr(package_edges, "ROOT", tmp_path)
    monkeypatch.setattr(package_edges, "SOURCES", tmp_path / "src")
    assert {(edge.used, edge.in_tests) for edge in code_edges()} == {
        ("cpp", False),
        ("module", False),
        ("place", True),
    }
