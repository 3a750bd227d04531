"""Packages, as far as files are found in them: where they are, and what their manifests say.

Without ROS these are the packages of the workspace that come with this one; whoever knows more says so by
`know_packages`.
"""

import contextlib
import functools
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable
from pathlib import Path
from typing import Optional, Protocol

from f1tenth_judge.errors import ScenarioError

_OWN = Path(__file__).resolve().parents[1]
# Installed by pip; in the workspace; in an install space of catkin.
_ROOTS = (_OWN / "data", _OWN.parents[2], _OWN.parents[3] / "share")
_MANIFEST = "package.xml"


class Packages(Protocol):
    """Where packages are."""

    def names(self) -> Iterable[str]:
        """Those that are installed."""

    def path(self, package: str) -> Optional[Path]:
        """The folder of a package; None if it is not installed."""


class _Beside:
    """The packages beside this one."""

    def names(self) -> Iterable[str]:
        return sorted({file.parent.name for root in _ROOTS for file in root.glob(f"*/{_MANIFEST}")})

    def path(self, package: str) -> Optional[Path]:
        return next((root / package for root in _ROOTS if (root / package / _MANIFEST).is_file()), None)


_known: Packages = _Beside()


def know_packages(packages: Packages) -> None:
    """Find packages where these are from now on, in this process."""
    global _known
    _known = packages
    exports.cache_clear()


def package_names() -> Iterable[str]:
    """The packages that are installed."""
    return _known.names()


def package_path(package: str) -> Path:
    """The folder of a package.

    Raises:
        ScenarioError: it is not installed, or the workspace is not sourced.
    """
    path = _known.path(package)
    if path is None:
        raise ScenarioError(f"package {package} not found; is the workspace's setup.bash sourced?")
    return path


def package_version(package: str) -> Optional[str]:
    """What the manifest of a package says; None if it is not installed."""
    path = _known.path(package)
    return None if path is None else _manifest(path).findtext("version")


def is_original(package: str) -> bool:
    """Whether a package is installed, and not as the workspace's stand-in, whose description says so."""
    path = _known.path(package)
    if path is None:
        return False
    return not (_manifest(path).findtext("description") or "").strip().startswith("Stand-in")


def in_package(file: Path) -> Optional[tuple[str, Path]]:
    """The package that a file is in, and its path there; None if that is not where the package is found."""
    folder = next((each for each in file.parents if (each / _MANIFEST).is_file()), None)
    if folder is None:
        return None
    with contextlib.suppress(ElementTree.ParseError, OSError):
        name, path = _manifest(folder).findtext("name", "").strip(), file.relative_to(folder)
        found = _known.path(name)
        # A package of this name may be another copy of it.
        if found and (found / path).samefile(file):
            return name, path
    return None


@functools.lru_cache
def exports(package: str, kind: str) -> list[Path]:
    """Folders that other packages export: <PACKAGE KIND="${prefix}/FOLDER"/>."""
    found = []
    for name in sorted(package_names()):
        folder = package_path(name)
        with contextlib.suppress(ElementTree.ParseError, OSError):
            values = (tag.get(kind) for tag in _manifest(folder).iterfind(f"export/{package}"))
            found += [value.replace("${prefix}", str(folder)) for value in values if value]
    return [Path(each) for each in found]


@functools.cache
def _manifest(folder: Path) -> ElementTree.Element:
    return ElementTree.parse(folder / _MANIFEST).getroot()
