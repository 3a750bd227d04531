"""Loads a map from its YAML and image files, and saves one."""

import json
from pathlib import Path

import yaml

from map_server.errors import MapSaveError
from map_server.files import replace_files
from map_server.grid_map import GridMap
from map_server.occupancy import pixels_from_cells
from map_server.pixels import read_cells

DEFAULT_OCCUPIED = 65
DEFAULT_FREE = 25


def load_map(metadata):
    """Load the map that `metadata` describes. Raises MapImageError."""
    return GridMap(cells=read_cells(metadata), resolution=metadata.resolution, origin=metadata.origin)


def save_map(grid, name, occupied_at_least=DEFAULT_OCCUPIED, free_at_most=DEFAULT_FREE):
    """Write NAME.pgm and NAME.yaml: both or none.

    Raises MapSaveError.
    """
    if grid.cells.size == 0:
        raise MapSaveError(f"the map has no cells: {grid.width} x {grid.height}")
    image, description = Path(f"{name}.pgm"), Path(f"{name}.yaml")
    replace_files(
        {
            image: pgm_bytes(grid, occupied_at_least, free_at_most),
            description: yaml_text(grid, image.name).encode(),
        }
    )
    return image, description


def pgm_bytes(grid, occupied_at_least, free_at_most):
    """Return the map as a binary PGM, the grid's last row first."""
    header = f"P5\n# CREATOR: map_saver.cpp {grid.resolution:.3f} m/pix\n{grid.width} {grid.height}\n255\n"
    pixels = pixels_from_cells(grid.cells, occupied_at_least, free_at_most)
    return header.encode() + pixels[::-1].tobytes()


def yaml_text(grid, image_name):
    """Return the YAML file that goes with the image."""
    x, y, yaw = grid.origin
    return (
        f"image: {_scalar(image_name)}\n"
        f"resolution: {grid.resolution:.6f}\n"
        f"origin: [{x:.6f}, {y:.6f}, {yaw:.6f}]\n"
        "negate: 0\n"
        "occupied_thresh: 0.65\n"
        "free_thresh: 0.196\n\n"
    )


def _scalar(text):
    """Quote a file name only where YAML would read something else."""
    try:
        plain = yaml.safe_load(f"image: {text}") == {"image": text}
    except yaml.YAMLError:
        plain = False
    return text if plain else json.dumps(text)
