"""Writes map files for the tests."""

import numpy as np
from PIL import Image

DESCRIPTION = {
    "image": "map.png",
    "resolution": "0.05",
    "origin": "[-1.0, 2.0, 0.5]",
    "negate": "0",
    "occupied_thresh": "0.65",
    "free_thresh": "0.196",
}


def write_description(folder, without=(), **changes):
    """Write folder/map.yaml: a good one, with keys changed to the given text or left out."""
    lines = {key: text for key, text in {**DESCRIPTION, **changes}.items() if key not in without}
    path = folder / "map.yaml"
    path.write_text("".join(f"{key}: {text}\n" for key, text in lines.items()))
    return path


def write_map(folder, pixels, **changes):
    """Write folder/map.png with these pixels (top row first) and folder/map.yaml."""
    Image.fromarray(np.asarray(pixels, dtype=np.uint8)).save(folder / "map.png")
    return write_description(folder, **changes)


def random_cells(seed, height=37, width=53):
    """Return a grid of -1, 0 and 100."""
    generator = np.random.default_rng(seed)
    return generator.choice(np.array([-1, 0, 100], dtype=np.int8), size=(height, width))
