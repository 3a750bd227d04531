"""What installed packages add to this one, by entry points of their distributions."""

import functools
from collections.abc import Mapping
from importlib.metadata import entry_points
from typing import Any


@functools.cache
def extensions(group: str) -> Mapping[str, Any]:
    """What is offered under the name of a group, by the names of the entry points.

    One that cannot be imported is missing: the module of a sourced workspace, say, in another Python.
    """
    found = {}
    for each in entry_points(group=group):
        try:
            found[each.name] = each.load()
        except ImportError:
            continue
    return found
