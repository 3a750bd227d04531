"""Who uses whom among the packages: read from manifests, includes, imports and launch files."""

import ast
import re
import subprocess
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ROOT / "src"

_INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
_MODULE = re.compile(r"PYBIND11_MODULE\((\w+),")
_FOUND = re.compile(r"""\$\(find ([\w-]+)\)|package://([\w-]+)/|\bpkg=["']([\w-]+)["']""")
_CPP = {".cpp", ".h", ".hpp"}
_DESCRIPTIONS = {".launch", ".test", ".xacro", ".urdf", ".world", ".rviz", ".sdf"}


@dataclass(frozen=True)
class Edge:
    """One package uses another."""

    user: str
    used: str
    where: str
    """File with the include, import, … relative to the workspace."""
    in_tests: bool


def packages():
    """Folder of each package of the workspace by its name."""
    manifests = [*SOURCES.glob("*/package.xml"), *SOURCES.glob("standins/*/package.xml")]
    return {ElementTree.parse(manifest).findtext("name"): manifest.parent for manifest in manifests}


def tracked_files(folder):
    """Paths of the files of a folder that git knows or would add, without packages inside it (fixtures)."""
    command = ["git", "-C", folder, "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    names = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split("\0")
    paths = [folder / name for name in names if name and (folder / name).is_file()]
    fixtures = {path.parent for path in paths if path.name == "package.xml" and path.parent != folder}
    return [path for path in paths if not fixtures.intersection(path.parents)]


def is_python(path):
    """Whether a file is Python, by its name or its first line."""
    if path.suffix == ".py":
        return True
    return (
        not path.suffix and path.read_bytes()[:2] == b"#!" and b"python" in path.read_bytes().split(b"\n")[0]
    )


def imported_modules(path):
    """Names that a Python file imports: `a.b` for `import a.b`, `a` and `a.b` for `from a import b`."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def included_files(path):
    """Names that a C++ file includes."""
    return _INCLUDE.findall(path.read_text(encoding="utf-8"))


def manifest_edges():
    """The edges that the package.xml files declare."""
    own = packages()
    for user, folder in own.items():
        for element in ElementTree.parse(folder / "package.xml").getroot():
            if element.tag.endswith("depend") and element.text in own:
                where = str((folder / "package.xml").relative_to(ROOT))
                yield Edge(user, element.text, where, element.tag == "test_depend")


def code_edges():
    """The edges that includes, imports, launch files and descriptions have."""
    own = packages()
    owner_of_module = {name: name for name in own}
    for name, folder in own.items():
        for source in folder.rglob("*.cpp"):
            owner_of_module.update(dict.fromkeys(_MODULE.findall(source.read_text(encoding="utf-8")), name))
    for user, folder in own.items():
        for path in tracked_files(folder):
            for name in sorted(_top_names(path)):
                used = owner_of_module.get(name, user)
                if used != user:
                    inside = path.relative_to(folder)
                    yield Edge(user, used, str(path.relative_to(ROOT)), _is_test(inside))


def _top_names(path):
    """Names of packages or modules that a file uses."""
    if path.suffix in _CPP:
        return {name.split("/")[0] for name in included_files(path) if "/" in name}
    if is_python(path):
        return {name.split(".")[0] for name in imported_modules(path)}
    if path.suffix in _DESCRIPTIONS or path.parent.name == "launch":
        text = path.read_text(encoding="utf-8", errors="replace")
        return {name for groups in _FOUND.findall(text) for name in groups if name}
    return set()


def _is_test(inside):
    return inside.parts[0] == "test" or inside.suffix == ".test"
