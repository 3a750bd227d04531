"""A circuit's file must be read, or refused with its place."""

import math

import pytest
from f1tenth_judge.errors import CircuitError, FileError
from f1tenth_judge.places.centreline import MAX_TURN, centreline
from f1tenth_judge.places.circuit_file import load_circuit
from f1tenth_judge.places.lap import Lap

SQUARE = """corners:
  - {at: [5.0, 0.0], radius: 2.0, width: 2.0}
  - {at: [5.0, 10.0], radius: 2.0, width: 2.0}
  - {at: [-5.0, 10.0], radius: 2.0, width: 2.0}
  - {at: [-5.0, 0.0], radius: 2.0, width: 2.0}
"""
KEYS = "corners, left_material, right_material, openings, rooms, props"


def write(tmp_path, text):
    path = tmp_path / "square.yaml"
    path.write_text(text)
    return path


def refusal(path):
    with pytest.raises(FileError) as raised:
        load_circuit(path)
    return str(raised.value).replace(str(path), "FILE")


def test_circuit_is_named_after_its_file(tmp_path):
    circuit = load_circuit(write(tmp_path, SQUARE))
    assert circuit.name == "square"
    assert len(circuit.corners) == 4


def test_centreline_turns_in_small_steps_and_keeps_its_radius(tmp_path):
    vertices = centreline(load_circuit(write(tmp_path, SQUARE)))
    lap = Lap(vertices)
    headings = [lap.pose(i * lap.length / 1000).yaw for i in range(1000)]
    turns = [abs(math.remainder(b - a, math.tau)) for a, b in zip(headings, headings[1:])]
    assert max(turns) <= MAX_TURN + 1e-9
    assert lap.length == pytest.approx(40 - 8 * 2.0 + 2 * 3.14159 * 2.0, abs=0.1)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "corners:",
            "corner:",
            f"1: unknown key 'corner'; allowed: {KEYS}\nFILE:1: missing key 'corners'; allowed: {KEYS}",
        ),
        (SQUARE, "left_material: Gazebo/Grey", f"1: missing key 'corners'; allowed: {KEYS}"),
        ("radius: 2.0", "radius: 1.1", "2: corners[0].radius is 1.1, must be at least 1.2 m"),
        ("width: 2.0", "width: 1.1", "2: corners[0].width is 1.1, must be at least 1.2 m and at most 2.5 m"),
        ("width: 2.0", "width: 2.6", "2: corners[0].width is 2.6, must be at least 1.2 m and at most 2.5 m"),
        ("width: 2.0", "width: wide", "2: corners[0].width must be a number (m), found 'wide'"),
        ("width: 2.0", "width: .nan", "2: corners[0].width must be a number (m), found '.nan'"),
        (
            "width: 2.0",
            "wide: 2.0",
            "2: unknown key 'wide' in corners[0]; allowed: at, radius, width\n"
            "FILE:2: missing key 'width' in corners[0]; allowed: at, radius, width",
        ),
        (", width: 2.0", "", "2: missing key 'width' in corners[0]; allowed: at, radius, width"),
        ("width: 2.0", "width: 2.0, z: 1", "2: unknown key 'z' in corners[0]; allowed: at, radius, width"),
        ("[5.0, 0.0]", "[5.0]", "2: corners[0].at must be a list of 2 numbers (x, y), found a list of 1"),
        ("[5.0, 0.0]", "[5.0, here]", "2: corners[0].at[1] must be a number (m), found 'here'"),
        (
            "{at: [5.0, 0.0], radius: 2.0, width: 2.0}",
            "7",
            "2: corners[0] must be a mapping with the keys at, radius, width, found '7'",
        ),
        (
            SQUARE,
            "corners: [{at: [5.0, 0.0], radius: 2.0, width: 2.0}]",
            "1: corners must be a list of at least 3, found a list of 1",
        ),
        (
            "[-5.0, 0.0]",
            "[-5.0, 1.0]",
            "2: corners must lead through the origin in direction +x from the last to the first,"
            " found (-5, 1) to (5, 0)",
        ),
    ],
)
def test_mistakes_are_named_with_their_place(tmp_path, old, new, message):
    assert refusal(write(tmp_path, SQUARE.replace(old, new, 1))) == f"FILE:{message}"


@pytest.mark.parametrize(
    ("addition", "message"),
    [
        ("openings: 3\n", "openings must be a list, found '3'"),
        (
            "openings: [{kind: hatch, near: [0, 1], width: 1}]\n",
            "openings[0].kind is 'hatch'; allowed: door, window",
        ),
        (
            "openings: [{kind: door, near: [0, 1], width: -1}]\n",
            "openings[0].width is -1, must be above 0 m",
        ),
        (
            "props: [{model: chair, at: [0, 1]}]\n",
            "props[0].at must be a list of 3 numbers (x, y, yaw), found a list of 2",
        ),
        (
            "rooms: [{points: [[0, 1], 2]}]\n",
            "rooms[0].points[1] must be a list of 2 numbers (x, y), found '2'",
        ),
        ("rooms: [{points: 3}]\n", "rooms[0].points must be a list, found '3'"),
        ("rooms: [{points: [[0, 1]]}]\n", "rooms[0].points must be a list of at least 2, found a list of 1"),
        ("left_material: 7\n", "left_material must be a text, found '7'"),
        ("props: [{model: 1, at: [0, 1, 2]}]\n", "props[0].model must be a text, found '1'"),
        ("colour: red\n", f"unknown key 'colour'; allowed: {KEYS}"),
        ("name: round\n", f"unknown key 'name'; allowed: {KEYS}"),
        ("corners: []\n", "key 'corners' is given twice, first in line 1"),
    ],
)
def test_mistakes_in_the_fittings_are_named_with_their_place(tmp_path, addition, message):
    assert refusal(write(tmp_path, SQUARE + addition)) == f"FILE:6: {message}"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("corners: [", "1: not YAML: expected the node content, but found '<stream end>'"),
        ("3", "1: must be a mapping of keys to values"),
    ],
)
def test_what_is_no_circuit_is_refused_in_one_line(tmp_path, text, message):
    assert refusal(write(tmp_path, text)) == f"FILE:{message}"


def test_a_missing_file_is_named(tmp_path):
    assert refusal(tmp_path / "none.yaml") == "FILE: cannot be read: No such file or directory"


def test_bends_that_need_more_room_than_there_is_are_refused(tmp_path):
    circuit = load_circuit(write(tmp_path, SQUARE.replace("radius: 2.0", "radius: 6.0")))
    with pytest.raises(
        CircuitError, match=r"corners\[3\] and corners\[0\]: their bends need 12.000 m of the 10.000 m"
    ):
        centreline(circuit)
