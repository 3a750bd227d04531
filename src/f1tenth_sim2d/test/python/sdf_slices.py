"""An independent reader and slicer of the worlds that the workspace ships, to compare scans with."""

import math
import xml.etree.ElementTree as ET

import numpy as np
from shapely.geometry import Polygon


def slice_world(path, models, z):
    """Return the section of a world's collision elements at height z, whether they can move or not.

    :param path: an SDF file whose things stand upright
    :param models: the folder in which model:// URIs are looked up
    :return: polygons (shapely) and circles (x, y, radius), m
    """
    polygons, circles = [], []
    for place, collision in _collisions(ET.parse(path).find("world"), np.eye(4), models):
        base = place @ _pose(collision)
        (shape,) = collision.find("geometry")
        section = _SLICERS[shape.tag](shape, base, z)
        if isinstance(section, Polygon):
            polygons.append(section)
        elif section is not None:
            circles.append(section)
    return polygons, circles


def _collisions(parent, place, models):
    """Yield (pose of its link, element) of each collision element below a world or a model."""
    for include in parent.findall("include"):
        name = include.find("uri").text.removeprefix("model://")
        model = ET.parse(models / name / "model.sdf").find("model")
        if model is not None:
            yield from _collisions_of(model, place, models, include)
    for model in parent.findall("model"):
        yield from _collisions_of(model, place, models)
    for link in parent.findall("link"):
        for collision in link.findall("collision"):
            yield place @ _pose(link), collision


def _collisions_of(model, place, models, include=None):
    placing = include if include is not None and include.find("pose") is not None else model
    return _collisions(model, place @ _pose(placing), models)


def _pose(element):
    pose = element.find("pose")
    if pose is None:
        return np.eye(4)
    assert not pose.attrib, "a pose relative to another is beyond this reader"
    x, y, z, roll, pitch, yaw = map(float, pose.text.split())
    assert (roll, pitch) == (0.0, 0.0), "what is tilted is beyond this reader"
    c, s = math.cos(yaw), math.sin(yaw)
    return np.array([[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, z], [0, 0, 0, 1]])


def _polygon(corners, base):
    return Polygon([(base @ (x, y, 0.0, 1.0))[:2] for x, y in corners])


def _numbers(shape, tag):
    return [float(number) for number in shape.find(tag).text.split()]


def _slice_box(shape, base, z):
    x, y, height = (0.5 * size for size in _numbers(shape, "size"))
    if abs(z - base[2, 3]) < height:
        return _polygon([(-x, -y), (x, -y), (x, y), (-x, y)], base)
    return None


def _slice_cylinder(shape, base, z):
    if abs(z - base[2, 3]) < 0.5 * _numbers(shape, "length")[0]:
        return base[0, 3], base[1, 3], _numbers(shape, "radius")[0]
    return None


def _slice_sphere(shape, base, z):
    squared = _numbers(shape, "radius")[0] ** 2 - (z - base[2, 3]) ** 2
    return (base[0, 3], base[1, 3], math.sqrt(squared)) if squared > 0.0 else None


def _slice_polyline(shape, base, z):
    if 0.0 < z - base[2, 3] < _numbers(shape, "height")[0]:
        corners = [tuple(map(float, point.text.split())) for point in shape.findall("point")]
        return _polygon(corners, base)
    return None


_SLICERS = {
    "box": _slice_box,
    "cylinder": _slice_cylinder,
    "sphere": _slice_sphere,
    "polyline": _slice_polyline,
    "plane": lambda *_: None,
}
