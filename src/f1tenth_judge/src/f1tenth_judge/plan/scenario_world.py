"""The world of a run: the scenario's own boxes put into a copy of the world file."""

import xml.etree.ElementTree as ElementTree
from pathlib import Path

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.scenario.scenario import Box, Scenario


def check_boxes(world: Path, scenario: Scenario) -> None:
    """Whether the scenario's boxes can be put into the world.

    Raises:
        ScenarioError: the world is no SDF file, or a model in it has the name of a box.
    """
    if not scenario.boxes:
        return
    names = {model.get("name") for model in _read(world).iter("model")}
    for index, box in enumerate(scenario.boxes):
        if box.name in names:
            raise ScenarioError(f"boxes[{index}].name is '{box.name}', and {world} has a model of that name")


def write_world(world: Path, scenario: Scenario, path: Path) -> None:
    """Write the world with the boxes in it.

    Raises:
        ScenarioError: as check_boxes.
    """
    root = _read(world)
    for parent in root.iterfind("world"):
        parent.extend(map(_model, scenario.boxes))
    ElementTree.ElementTree(root).write(path, encoding="utf-8", xml_declaration=True)


def _read(world: Path) -> ElementTree.Element:
    try:
        root = ElementTree.parse(world).getroot()
    except (OSError, ElementTree.ParseError) as error:
        raise ScenarioError(f"boxes need a world in SDF, and {world} is none: {error}") from error
    if root.find("world") is None:
        raise ScenarioError(f"boxes need a world in SDF, and {world} has no <world>")
    return root


def _model(box: Box) -> ElementTree.Element:
    model = ElementTree.Element("model", name=box.name)
    _add(model, "static", "0" if box.movable else "1")
    _add(model, "pose", f"{box.x} {box.y} {box.height / 2} 0 0 {box.yaw}")
    link = ElementTree.SubElement(model, "link", name="link")
    if box.movable:
        _add_inertial(link, box)
    for kind in ("collision", "visual"):
        geometry = ElementTree.SubElement(ElementTree.SubElement(link, kind, name=kind), "geometry")
        _add(ElementTree.SubElement(geometry, "box"), "size", f"{box.length} {box.width} {box.height}")
    return model


def _add_inertial(link: ElementTree.Element, box: Box) -> None:
    inertial = ElementTree.SubElement(link, "inertial")
    _add(inertial, "mass", str(box.mass))
    inertia = ElementTree.SubElement(inertial, "inertia")
    squares = {"xx": (box.width, box.height), "yy": (box.length, box.height), "zz": (box.length, box.width)}
    for axis, (one, other) in squares.items():
        _add(inertia, f"i{axis}", str(box.mass * (one**2 + other**2) / 12))


def _add(parent: ElementTree.Element, tag: str, text: str) -> None:
    ElementTree.SubElement(parent, tag).text = text
