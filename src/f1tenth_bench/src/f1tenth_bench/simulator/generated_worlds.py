"""Worlds that are made for a measurement."""

import math
import tempfile
from pathlib import Path

import f1tenth_sim2d

WALL_THICKNESS = 0.15  # m
WALL_HEIGHT = 2.5  # m
RING_RADIUS = 6.0  # m, of the centre line
RING_HALF_WIDTH = 1.0  # m
BOXES_A_RING = 50
ROOM_SIZE = 5.0  # m, inside
BOXES_A_SIDE = 6
SEGMENTS_A_ROOM = 4 * (4 * BOXES_A_SIDE + 1)


def ring_track():
    """Return a round track between two rings of wall boxes, its centre in (0, RING_RADIUS)."""
    boxes = []
    for radius in (RING_RADIUS - RING_HALF_WIDTH, RING_RADIUS + RING_HALF_WIDTH):
        length = 2.0 * radius * math.tan(math.pi / BOXES_A_RING) + WALL_THICKNESS
        for i in range(BOXES_A_RING):
            angle = 2.0 * math.pi * i / BOXES_A_RING
            x, y = radius * math.cos(angle), RING_RADIUS + radius * math.sin(angle)
            boxes.append((x, y, angle + 0.5 * math.pi, length, WALL_THICKNESS))
    return _world(boxes)


def ring_pose(car, count):
    """(x, y, yaw) of one of several cars at equal distances on the centre line of the ring track."""
    angle = 2.0 * math.pi * car / count - 0.5 * math.pi
    return RING_RADIUS * math.cos(angle), RING_RADIUS * (1.0 + math.sin(angle)), angle + 0.5 * math.pi


def rooms(count):
    """Return closed rooms of SEGMENTS_A_ROOM wall segments side by side, one of them around the origin."""
    columns = math.ceil(math.sqrt(count))
    pitch = ROOM_SIZE + 2.0 * WALL_THICKNESS
    boxes = []
    for room in range(count):
        column, row = room % columns - columns // 2, room // columns - count // columns // 2
        boxes += _room(column * pitch, row * pitch)
    return _world(boxes)


def _room(x, y):
    half = 0.5 * (ROOM_SIZE + WALL_THICKNESS)
    length = ROOM_SIZE / BOXES_A_SIDE
    boxes = [(x + 1.5, y + 1.0, 0.3, 0.3, 0.3)]
    for i in range(BOXES_A_SIDE):
        along = (i + 0.5) * length - 0.5 * ROOM_SIZE
        for side in (-half, half):
            boxes.append((x + along, y + side, 0.0, length, WALL_THICKNESS))
            boxes.append((x + side, y + along, 0.5 * math.pi, length, WALL_THICKNESS))
    return boxes


def _world(boxes):
    """Return the World of boxes (x, y, yaw, length, width), through a file, as a user's world comes."""
    collisions = "".join(
        f"<collision name='c{i}'><pose>{x} {y} {WALL_HEIGHT / 2} 0 0 {yaw}</pose>"
        f"<geometry><box><size>{length} {width} {WALL_HEIGHT}</size></box></geometry></collision>"
        for i, (x, y, yaw, length, width) in enumerate(boxes)
    )
    model = f"<model name='walls'><static>true</static><link name='link'>{collisions}</link></model>"
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "bench.world"
        file.write_text(f"<sdf version='1.7'><world name='bench'>{model}</world></sdf>")
        return f1tenth_sim2d.load_world(str(file))
