"""Writes a road as map, centreline and world."""

from pathlib import Path

import numpy as np
from f1tenth_judge.atomic import write_all
from f1tenth_judge.places.centreline_file import table_text
from f1tenth_judge.places.map_file import map_files
from PIL import Image, ImageDraw

from f1tenth_gazebo.maps.occupancy import grid_of, occupied_cells
from f1tenth_gazebo.roads.road_walls import MATERIAL
from f1tenth_gazebo.worlds.world_file import road_world_text

_CENTRELINE_STEP = 3
"""The file has every n-th sample of the line."""


def write_road(road, stem):
    """Write STEM.pgm, STEM.yaml, STEM_centerline.csv and STEM.world; STEM is a path without extension.

    Returns:
        The paths, in this order. All of them are written, or none is.

    Raises:
        OSError: if a file cannot be written.
    """
    stem = Path(stem)
    content = {
        **map_files(road_grid(road), stem),
        stem.with_name(f"{stem.name}_centerline.csv"): centreline_text(road).encode(),
        stem.with_name(f"{stem.name}.world"): road_world_text(
            stem.name, road.walls, road.islands, MATERIAL
        ).encode(),
    }
    write_all(content)
    return list(content)


def road_grid(road):
    """The road as a map: walls and islands occupied, the ground between the walls free, all else unknown."""
    cell = road.options.cell
    occupied, low = occupied_cells(road.outlines(), road.islands, cell)
    inside = Image.new("1", occupied.shape[::-1])
    draw = ImageDraw.Draw(inside)
    for ring, fill in ((road.inside.exterior, 1), (road.inside.interiors[0], 0)):
        draw.polygon([tuple(p) for p in (np.array(ring.coords) - low) / cell - 0.5], fill=fill)
    return grid_of(occupied, np.asarray(inside), low, cell)


def centreline_text(road):
    """The line in the format of f1tenth_racetracks, from the start on."""
    columns = np.column_stack([road.line.points, road.to_right, road.to_left])
    return table_text(columns[::_CENTRELINE_STEP])
