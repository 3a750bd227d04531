"""A map as map_saver writes it: NAME.pgm and NAME.yaml."""

from pathlib import Path

from f1tenth_gazebo.whole_files import write_all

_YAML = """image: {image}
resolution: {resolution:.6f}
origin: [{x:.6f}, {y:.6f}, 0.000000]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196

"""


def pgm_bytes(grid):
    """The image, top row first."""
    rows, columns = grid.pixels.shape
    header = f"P5\n# CREATOR: make_map {grid.resolution:.3f} m/pix\n{columns} {rows}\n255\n"
    return header.encode() + grid.pixels[::-1].tobytes()


def yaml_text(grid, image):
    """What map_server needs to know of the image."""
    return _YAML.format(image=image, resolution=grid.resolution, x=grid.x, y=grid.y)


def save_map(grid, stem):
    """Write STEM.pgm and STEM.yaml, both or none; STEM is a path without extension.

    Raises:
        OSError: if a file cannot be written.
    """
    stem = Path(stem)
    image = stem.with_name(f"{stem.name}.pgm")
    write_all(
        {image: pgm_bytes(grid), stem.with_name(f"{stem.name}.yaml"): yaml_text(grid, image.name).encode()}
    )
