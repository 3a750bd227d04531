"""Which folders of a package use each other, read from its includes and imports."""

import graphlib
import os
from collections import defaultdict
from pathlib import Path

from package_edges import imported_modules, included_files, is_python, tracked_files

_CPP = {".cpp", ".h", ".hpp"}


def file_edges(folder):
    """Pairs (user, used) of files of one package, its tests left aside: paths relative to its folder."""
    files = [path for path in tracked_files(folder) if path.relative_to(folder).parts[0] != "test"]
    by_end = _by_end(folder, files)
    for path in files:
        if path.suffix in _CPP:
            names = [_beside(path, name) or name for name in included_files(path)]
        elif is_python(path):
            names = [module.replace(".", "/") for module in imported_modules(path)]
        else:
            continue
        for name in names:
            used = by_end.get(name)
            if used and used != path:
                yield path.relative_to(folder), used.relative_to(folder)


def _beside(path, name):
    """Path of an included file that is found from the folder of the one that includes it; "" if it is not."""
    beside = Path(os.path.normpath(path.parent / name))
    return str(beside) if beside.is_file() else ""


def _by_end(folder, files):
    """Files by what includes and imports may call them: every end of their path, modules without suffix."""
    found = {}
    for path in files:
        parts = path.relative_to(folder).parts
        if path.name == "__init__.py":
            parts = parts[:-1]
        elif path.suffix == ".py":
            parts = (*parts[:-1], path.stem)
        found[str(path)] = path
        for start in range(len(parts) - 1):
            found.setdefault("/".join(parts[start:]), path)
    return found


def sibling_graphs(folder):
    """For each folder of a package: who of its entries (folders and files) uses which others.

    Returns:
        {folder: {entry: {used entry: an example "user -> used"}}}; entries are paths relative to the package.
    """
    graphs = defaultdict(lambda: defaultdict(dict))
    for user, used in file_edges(folder):
        depth = next(i for i, (a, b) in enumerate(zip(user.parts, used.parts)) if a != b)
        parent = "/".join(user.parts[:depth])
        entry, other = ("/".join(path.parts[: depth + 1]) for path in (user, used))
        graphs[parent][entry].setdefault(other, f"{user} -> {used}")
    return graphs


def circle(graph):
    """Entries that use each other in a circle, the first again at the end; empty if there are none."""
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as error:
        return error.args[1][::-1]
    return []
