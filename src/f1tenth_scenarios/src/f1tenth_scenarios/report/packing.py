"""Columns of numbers as text that a browser decodes fast: quantised, as differences, deflated, in base64.

Each value is divided by the column's quantum and rounded; its difference to the one `stride` before is taken
`order` times modulo 256**width, and the bytes are written plane by plane (all lowest bytes first), which
deflate likes. What the columns are stands before them as JSON. `decode.js` is the other end.
"""

import base64
import json
import zlib
from collections.abc import Sequence
from typing import Any

import numpy as np

_WIDTHS = {1: np.uint8, 2: np.uint16, 4: np.uint32}  # bytes of a value


class Packer:
    """Takes columns one after the other."""

    def __init__(self):
        self._columns: list[dict[str, Any]] = []
        self._planes: list[bytes] = []

    def add(
        self, name: str, values: Sequence[float], quantum: float, stride: int = 1, order: int = 1
    ) -> None:
        """Append a column.

        Args:
            name: by which the browser finds it
            values: finite numbers
            quantum: to a multiple of which they are rounded
            stride: how far back the value lies that each one resembles most, as the width of a table
            order: how often differences are taken; 2 suits what changes steadily

        Raises:
            ValueError: a value is not finite, or needs more than four bytes.
        """
        array = np.asarray(values, dtype=float).ravel()
        if not np.isfinite(array).all():
            raise ValueError(f"{name} has values that are not finite")
        whole = np.rint(array / quantum).astype(np.int64)
        offset = int(whole.min()) if len(whole) else 0
        width = _width(name, int((whole - offset).max()) if len(whole) else 0)
        self._planes.append(_planes(whole - offset, width, stride, order))
        self._columns.append(
            {
                "name": name,
                "count": len(whole),
                "width": width,
                "quantum": quantum,
                "offset": offset,
                "stride": stride,
                "order": order,
            }
        )

    def pack(self) -> str:
        """All that was added."""
        head = json.dumps(self._columns, separators=(",", ":")).encode()
        return _deflated(len(head).to_bytes(4, "little") + head + b"".join(self._planes))


def pack_json(content: Any) -> str:
    """What JSON can hold, as text for `decodeJson` of decode.js."""
    return _deflated(json.dumps(content, separators=(",", ":")).encode())


def _deflated(data: bytes) -> str:
    return base64.b64encode(zlib.compress(data, 9)).decode("ascii")


def _width(name: str, largest: int) -> int:
    for width in _WIDTHS:
        if largest < 256**width:
            return width
    raise ValueError(f"{name} spans more than four bytes")


def _planes(whole: np.ndarray, width: int, stride: int, order: int) -> bytes:
    differences = whole.copy()
    for _ in range(order):
        differences[stride:] -= differences[:-stride].copy()
    as_bytes = differences.astype(_WIDTHS[width]).view(np.uint8).reshape(-1, width)
    return as_bytes.T.tobytes()
