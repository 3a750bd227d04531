"""Sine, exponential and others with the same bits on every machine, of numbers and of numpy arrays.

Those of `math` and numpy come from the C library or choose their code by the processor, and differ in the
last bit; whatever a trajectory depends on uses these. `math.sqrt`, `math.fmod`, `math.remainder` and whatever
else is exact needs no twin. For accuracy and domains see `workspace_support/maths/*.h`; no result is nan.
"""

from workspace_support._maths import (
    acos,
    asin,
    atan,
    atan2,
    cbrt,
    cos,
    exp,
    hypot,
    log,
    pow,
    sin,
    tan,
)

__all__ = ["acos", "asin", "atan", "atan2", "cbrt", "cos", "exp", "hypot", "log", "pow", "sin", "tan"]
