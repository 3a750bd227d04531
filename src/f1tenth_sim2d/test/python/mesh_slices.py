"""An independent reader and slicer of meshes, to compare the sections of the simulator with."""

import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np

COLLADA = "{http://www.collada.org/2005/11/COLLADASchema}"


def triangles_of(path):
    """Return the triangles of a DAE or binary STL file in metres, an array of shape (n, 3, 3)."""
    return _triangles_of_stl(path) if Path(path).suffix == ".stl" else _triangles_of_dae(path)


def _triangles_of_stl(path):
    facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    return np.fromfile(path, dtype=facet, offset=84)["corners"].astype(float)


def _triangles_of_dae(path):
    root = ET.parse(path).getroot()
    scale = float(root.find(f"{COLLADA}asset/{COLLADA}unit").get("meter"))
    geometries = {g.get("id"): _triangles_of_geometry(g) for g in root.iter(f"{COLLADA}geometry")}
    nodes = {n.get("id"): n for n in root.iter(f"{COLLADA}node") if n.get("id")}
    found = []
    for top in root.find(f"{COLLADA}library_visual_scenes/{COLLADA}visual_scene").findall(f"{COLLADA}node"):
        _collect(top, np.eye(4), geometries, nodes, found)
    return scale * np.concatenate(found)


def _collect(node, transform, geometries, nodes, found):
    matrix = node.find(f"{COLLADA}matrix")
    if matrix is not None:
        transform = transform @ np.array(matrix.text.split(), dtype=float).reshape(4, 4)
    for instance in node.findall(f"{COLLADA}instance_geometry"):
        corners = geometries[instance.get("url")[1:]]
        found.append(corners @ transform[:3, :3].T + transform[:3, 3])
    for instance in node.findall(f"{COLLADA}instance_node"):
        _collect(nodes[instance.get("url")[1:]], transform, geometries, nodes, found)
    for child in node.findall(f"{COLLADA}node"):
        _collect(child, transform, geometries, nodes, found)


def _triangles_of_geometry(geometry):
    mesh = geometry.find(f"{COLLADA}mesh")
    positions = mesh.find(f"{COLLADA}vertices/{COLLADA}input[@semantic='POSITION']").get("source")[1:]
    source = mesh.find(f"{COLLADA}source[@id='{positions}']/{COLLADA}float_array")
    points = np.array(source.text.split(), dtype=float).reshape(-1, 3)
    corners = [points[_corners_of(primitive)] for primitive in _primitives(mesh)]
    return np.concatenate(corners) if corners else np.empty((0, 3, 3))


def _primitives(mesh):
    return [*mesh.findall(f"{COLLADA}triangles"), *mesh.findall(f"{COLLADA}polylist")]


def _corners_of(primitive):
    """Return the vertex numbers of the triangles, polygons cut into fans, an array of shape (n, 3)."""
    inputs = primitive.findall(f"{COLLADA}input")
    stride = 1 + max(int(i.get("offset")) for i in inputs)
    offset = next(int(i.get("offset")) for i in inputs if i.get("semantic") == "VERTEX")
    index = np.array(primitive.find(f"{COLLADA}p").text.split(), dtype=int)[offset::stride]
    sizes = primitive.find(f"{COLLADA}vcount")
    if sizes is None:
        return index.reshape(-1, 3)
    polygons = np.split(index, np.cumsum(np.array(sizes.text.split(), dtype=int))[:-1])
    return np.array([(p[0], p[i], p[i + 1]) for p in polygons for i in range(1, len(p) - 1)])


def placed(triangles, scale, xyz, rpy):
    """Return the triangles scaled, turned (roll, pitch, yaw about fixed axes, rad) and moved (m)."""
    (cr, cp, cy), (sr, sp, sy) = np.cos(rpy), np.sin(rpy)
    roll = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    pitch = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    yaw = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
    return scale * triangles @ (yaw @ pitch @ roll).T + np.array(xyz)


def slice_at(triangles, z):
    """Return where the plane at height z cuts the triangles: segments, an array of shape (n, 2, 2)."""
    segments = []
    for corners in triangles:
        above = corners[:, 2] > z
        if above.all() or not above.any():
            continue
        lone = int(np.argmax(above)) if above.sum() == 1 else int(np.argmin(above))
        ends = []
        for other in ((lone + 1) % 3, (lone + 2) % 3):
            share = (z - corners[lone, 2]) / (corners[other, 2] - corners[lone, 2])
            ends.append(corners[lone, :2] + share * (corners[other, :2] - corners[lone, :2]))
        segments.append(ends)
    return np.array(segments).reshape(-1, 2, 2)
