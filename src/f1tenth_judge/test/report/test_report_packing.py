"""Columns survive being packed, to within their quantum."""

import base64
import json
import zlib

import numpy as np
import pytest
from f1tenth_judge.report.packing import column, pack


def unpacked(packed):
    """As decode.js does it."""
    return json.loads(zlib.decompress(base64.b64decode(packed)))


def values_of(packed_column):
    """As decode.js does it."""
    quantum, *changes = packed_column
    return np.cumsum(np.cumsum(changes)) * quantum


@pytest.mark.parametrize("span", [0.1, 10.0, 100_000.0])
def test_values_come_back(span):
    values = np.random.default_rng(1).uniform(-span, span, 500)
    found = unpacked(pack({"a": column(values, 0.001), "b": column(values[::-1], 0.01)}))
    assert np.abs(values_of(found["a"]) - values).max() <= 0.0005 + 1e-9
    assert np.abs(values_of(found["b"]) - values[::-1]).max() <= 0.005 + 1e-9


def test_what_changes_steadily_is_nearly_all_zeros():
    assert column(np.arange(100.0, 200.0, 10.0), 0.5) == [0.5, 200, -180, *[0] * 8]


def test_what_json_holds_is_packed_too():
    assert unpacked(pack({"a": [1, "ü"]})) == {"a": [1, "ü"]}


def test_empty_column_is_one():
    assert values_of(column([], 1)).size == 0
