"""Columns survive being packed, to within their quantum."""

import base64
import json
import zlib

import numpy as np
import pytest
from f1tenth_scenarios.report.packing import Packer, pack_json

_TYPES = {1: np.uint8, 2: np.uint16, 4: np.uint32}


def unpack(packed):
    """As decode.js does it."""
    data = zlib.decompress(base64.b64decode(packed))
    size = int.from_bytes(data[:4], "little")
    columns, data = json.loads(data[4 : 4 + size]), data[4 + size :]
    values = {}
    for column in columns:
        size = column["count"] * column["width"]
        planes = np.frombuffer(data[:size], np.uint8).reshape(column["width"], -1)
        data = data[size:]
        whole = np.ascontiguousarray(planes.T).view(_TYPES[column["width"]]).ravel().copy()
        for _ in range(column["order"]):
            for index in range(column["stride"], len(whole)):
                whole[index] += whole[index - column["stride"]]
        values[column["name"]] = (whole.astype(float) + column["offset"]) * column["quantum"]
    assert not data
    return values, columns


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
    unpacked, _ = unpack(packed)
    assert np.abs(unpacked["a"] - values).max() <= 0.0005 + 1e-9
    assert np.abs(unpacked["b"] - values[::-1]).max() <= 0.005 + 1e-9


@pytest.mark.filterwarnings("ignore:overflow")
def test_rows_of_a_table_are_held_against_the_row_before():
    table = np.arange(60.0).reshape(20, 3)
    values, _ = unpack(pack(("a", table, 1, 3)))
    assert (values["a"] == table.ravel()).all()


@pytest.mark.filterwarnings("ignore:overflow")
def test_differences_of_differences_come_back_and_take_less():
    values = np.cumsum(np.cumsum(np.random.default_rng(1).normal(0.0, 0.02, 500)))
    sizes = {}
    for order in (1, 2):
        packed = pack(("a", values, 0.01, 1, order))
        found, _ = unpack(packed)
        assert np.abs(found["a"] - values).max() <= 0.005 + 1e-9
        sizes[order] = len(packed)
    assert sizes[2] < sizes[1]


def test_what_json_holds_is_packed_too():
    assert json.loads(zlib.decompress(base64.b64decode(pack_json({"a": [1, "ü"]})))) == {"a": [1, "ü"]}


def test_small_ranges_take_one_byte():
    _, columns = unpack(pack(("a", [0, 255], 1), ("b", [0, 256], 1)))
    assert [column["width"] for column in columns] == [1, 2]


def test_empty_column_is_one():
    values, _ = unpack(pack(("a", [], 1)))
    assert values["a"].size == 0


@pytest.mark.parametrize(
    ("values", "problem"),
    [([0.0, float("nan")], "a has values that are not finite"), ([0, 2**33], "a spans more than four bytes")],
)
def test_what_cannot_be_packed_is_refused(values, problem):
    with pytest.raises(ValueError, match=problem):
        pack(("a", values, 1))
