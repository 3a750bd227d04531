"""A circuit's file must be read, or refused with its place."""

import math
import re

import pytest
from f1tenth_gazebo.circuits.centreline import MAX_TURN, centreline
from f1tenth_gazebo.circuits.circuit_file import load_circuit
from f1tenth_gazebo.circuits.lap import Lap
from f1tenth_gazebo.errors import CircuitError

SQUARE = """corners:
  - {at: [5.0, 0.0], radius: 2.0, width: 2.0}
  - {at: [5.0, 10.0], radius: 2.0, width: 2.0}
  - {at: [-5.0, 10.0], radius: 2.0, width: 2.0}
  - {at: [-5.0, 0.0], radius: 2.0, width: 2.0}
"""


def write(tmp_path, text):
    path = tmp_path / "square.yaml"
    path.write_text(text)
    return path


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
        ("corners:", "corner:", "the file: corners is missing"),
        ("radius: 2.0", "radius: 1.1", "corners[0].radius: found 1.1, allowed: at least 1.2 m"),
        ("width: 2.0", "width: 2.6", "corners[0].width: found 2.6, allowed: 1.2 to 2.5 m"),
        ("width: 2.0", "width: wide", "corners[0].width: found 'wide', allowed: a number"),
        ("width: 2.0", "width: .nan", "corners[0].width: found nan, allowed: a number"),
        ("width: 2.0", "wide: 2.0", "corners[0]: width is missing"),
        ("width: 2.0", "width: 2.0, z: 1", "corners[0]: unknown key 'z', allowed: at, radius, width"),
        ("[5.0, 0.0]", "[5.0]", "corners[0].at: found [5.0], allowed: a list of 2 numbers"),
        ("{at: [5.0, 0.0], radius: 2.0, width: 2.0}", "7", "corners[0]: found 7, allowed: a mapping"),
        (
            "[-5.0, 0.0]",
            "[-5.0, 1.0]",
            "corners: the way from the last to the first must lead through the origin",
        ),
    ],
)
def test_mistakes_are_named_with_their_place(tmp_path, old, new, message):
    path = write(tmp_path, SQUARE.replace(old, new, 1))
    with pytest.raises(CircuitError, match="^" + re.escape(f"{path}: {message}")):
        load_circuit(path)


@pytest.mark.parametrize(
    ("addition", "message"),
    [
        ("openings: 3\n", "openings: found 3, allowed: a list"),
        (
            "openings: [{kind: hatch, near: [0, 1], width: 1}]\n",
            "openings[0].kind: found 'hatch', allowed: door, window",
        ),
        ("props: [{model: chair, at: [0, 1]}]\n", "props[0].at: found [0, 1], allowed: a list of 3 numbers"),
        ("rooms: [{points: [[0, 1], 2]}]\n", "rooms[0].points[1]: found 2, allowed: a list of 2 numbers"),
        ("rooms: [{points: 3}]\n", "rooms[0].points: found 3, allowed: a list"),
        ("rooms: [{points: [[0, 1]]}]\n", "rooms[0].points: found 1, allowed: at least 2"),
        ("left_material: 7\n", "left_material: found 7, allowed: a text"),
        ("props: [{model: 1, at: [0, 1, 2]}]\n", "props[0].model: found 1, allowed: a text"),
        ("colour: red\n", "the file: unknown key 'colour', allowed: corners, left_material"),
    ],
)
def test_mistakes_in_the_fittings_are_named_with_their_place(tmp_path, addition, message):
    path = write(tmp_path, SQUARE + addition)
    with pytest.raises(CircuitError, match="^" + re.escape(f"{path}: {message}")):
        load_circuit(path)


@pytest.mark.parametrize("text", ["corners: [", "3"])
def test_what_is_no_circuit_is_refused_in_one_line(tmp_path, text):
    path = write(tmp_path, text)
    with pytest.raises(CircuitError, match="^" + re.escape(str(path))) as raised:
        load_circuit(path)
    assert "\n" not in str(raised.value)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(CircuitError, match="none.yaml: .*No such file"):
        load_circuit(tmp_path / "none.yaml")


def test_bends_that_need_more_room_than_there_is_are_refused(tmp_path):
    circuit = load_circuit(write(tmp_path, SQUARE.replace("radius: 2.0", "radius: 6.0")))
    with pytest.raises(
        CircuitError, match=r"corners\[3\] and corners\[0\]: their bends need 12.000 m of the 10.000 m"
    ):
        centreline(circuit)
