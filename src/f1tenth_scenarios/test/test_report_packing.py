"""Columns survive being packed, to within their quantum."""

import base64
import zlib

import numpy as np
import pytest
from f1tenth_scenarios.report.packing import Packer

_TYPES = {1: np.uint8, 2: np.uint16, 4: np.uint32}


def unpack(packed):
    """As decode.js does it."""
    data = zlib.decompress(base64.b64decode(packed.data))
    values = {}
    for column in packed.columns:
        size = column["count"] * column["width"]
        planes = np.frombuffer(data[:size], np.uint8).reshape(column["width"], -1)
        data = data[size:]
        whole = np.ascontiguousarray(planes.T).view(_TYPES[column["width"]]).ravel().copy()
        for index in range(column["stride"], len(whole)):
            whole[index] += whole[index - column["stride"]]
        values[column["name"]] = (whole.astype(float) + column["offset"]) * column["quantum"]
    assert not data
    return values


def pack(*columns):
    packer = Packer()
    for column in columns:
        packer.add(*column)
    return packer.pack()


@pytest.mark.filterwarnings("ignore:overflow")
@pytest.mark.parametrize("span", [0.1, 10.0, 100_000.0])
def test_values_come_back(span):
    values = np.random.default_rng(1).uniform(-span, span, 500)
    packed = pack(("a", values, 0.001), ("b", values[::-1], 0.01))
    unpacked = unpack(packed)
    assert np.abs(unpacked["a"] - values).max() <= 0.0005 + 1e-9
    assert np.abs(unpacked["b"] - values[::-1]).max() <= 0.005 + 1e-9


@pytest.mark.filterwarnings("ignore:overflow")
def test_rows_of_a_table_are_held_against_the_row_before():
    table = np.arange(60.0).reshape(20, 3)
    assert (unpack(pack(("a", table, 1, 3)))["a"] == table.ravel()).all()


def test_small_ranges_take_one_byte():
    assert [column["width"] for column in pack(("a", [0, 255], 1), ("b", [0, 256], 1)).columns] == [1, 2]


def test_empty_column_is_one():
    assert unpack(pack(("a", [], 1)))["a"].size == 0


@pytest.mark.parametrize(
    ("values", "problem"),
    [([0.0, float("nan")], "a has values that are not finite"), ([0, 2**33], "a spans more than four bytes")],
)
def test_what_cannot_be_packed_is_refused(values, problem):
    with pytest.raises(ValueError, match=problem):
        pack(("a", values, 1))
