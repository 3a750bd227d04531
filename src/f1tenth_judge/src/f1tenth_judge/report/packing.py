"""Numbers as text that a browser decodes fast: JSON, deflated, in base64; `decode.js` is the other end.

A column is a list of its quantum and of differences of differences: how far each value, as a multiple of the
quantum, is from the linear extrapolation of the two before it. Deflate likes such small whole numbers.
"""

import base64
import json
import zlib
from typing import Any

import numpy as np
from numpy.typing import ArrayLike


def column(values: ArrayLike, quantum: float) -> list[float]:
    """A column for `pack`.

    Args:
        values: finite numbers
        quantum: they are rounded to multiples of it
    """
    whole = np.rint(np.asarray(values, dtype=float) / quantum).astype(np.int64)
    return [quantum, *np.diff(whole, n=2, prepend=[0, 0]).tolist()]


def pack(content: Any) -> str:
    """What JSON can hold, as text."""
    text = json.dumps(content, separators=(",", ":"))
    return base64.b64encode(zlib.compress(text.encode(), 8)).decode("ascii")
