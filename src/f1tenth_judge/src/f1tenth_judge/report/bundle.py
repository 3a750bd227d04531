"""The page's modules as one script, because a page that is opened from a disk may import none."""

import re
from pathlib import Path

_IMPORT = re.compile(r'^import \{[^}]*\} from "(\.[^"]+)";\n', re.MULTILINE)
_EXPORT = re.compile(r"^export ", re.MULTILINE)


def bundle(entry: Path) -> str:
    """A module after all those that it imports, each once; their names share one scope."""
    return "\n".join(_modules(entry.resolve(), set()))


def _modules(module: Path, taken: set[Path]) -> list[str]:
    if module in taken:
        return []
    taken.add(module)
    text = module.read_text(encoding="utf-8")
    before = [
        part for name in _IMPORT.findall(text) for part in _modules((module.parent / name).resolve(), taken)
    ]
    return [*before, _EXPORT.sub("", _IMPORT.sub("", text))]
