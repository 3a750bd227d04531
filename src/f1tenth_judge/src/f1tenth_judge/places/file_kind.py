"""What a file is that somebody has named: seen from its first lines, before all of it is read."""

import re
from pathlib import Path
from typing import Optional

_YAML = (".yaml", ".yml")
_HEAD = 100_000  # bytes


def is_place(path: Path) -> bool:
    """Whether a file is a world (SDF) or the YAML of a map."""
    return why_no_place(path) is None


def why_no_place(path: Path) -> Optional[str]:
    """What a file is instead of a world or a map; None if it is one."""
    with path.open("rb") as file:
        head = file.read(_HEAD)
    if path.suffix.lower() not in _YAML:
        # UTF-8 and UTF-16, with and without a byte order mark.
        is_xml = head.lstrip(b"\xef\xbb\xbf\xff\xfe\x00 \t\r\n").startswith(b"<")
        return None if is_xml else "is no world: it does not begin as SDF does, with '<'"
    text = head.decode(errors="replace")
    if _has_key("image", text):
        return None
    is_scenario = _has_key("cars", text)
    return f"is a scenario: `f1tenth run {path}`" if is_scenario else "is no map: it has no key 'image'"


def _has_key(key: str, yaml: str) -> bool:
    return re.search(rf"(^|[{{,])\s*[\"']?{key}[\"']?\s*:", yaml, re.MULTILINE) is not None
