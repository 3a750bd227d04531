"""From the darkness of a pixel to the value of a cell of the grid, and back."""

import numpy as np

OCCUPIED = 100
FREE = 0
UNKNOWN = -1

PIXEL_OCCUPIED = 0
PIXEL_FREE = 254
PIXEL_UNKNOWN = 205


def cells_from_brightness(brightness, metadata):
    """Return the int8 cells that pixels of this brightness (array of floats, 0 to 255) stand for."""
    if metadata.negate:
        brightness = 255 - brightness
    if metadata.mode == "raw":
        # A cell is a signed byte: brightness above 127 comes out negative, as from the original.
        return brightness.astype(np.uint8).view(np.int8)
    occupancy = (255 - brightness) / 255.0
    between = np.full(occupancy.shape, UNKNOWN, dtype=np.int8)
    if metadata.mode == "scale":
        between = _scaled(occupancy, metadata)
    return np.select(
        [occupancy > metadata.occupied_thresh, occupancy < metadata.free_thresh],
        [np.int8(OCCUPIED), np.int8(FREE)],
        between,
    )


def _scaled(occupancy, metadata):
    ratio = (occupancy - metadata.free_thresh) / (metadata.occupied_thresh - metadata.free_thresh)
    return np.clip(1 + 98 * ratio, FREE, OCCUPIED).astype(np.int8)


def pixels_from_cells(cells, occupied_at_least, free_at_most):
    """Return the uint8 pixels that mean free, occupied or unknown; same shape as the int8 cells."""
    pixels = np.full(cells.shape, PIXEL_UNKNOWN, dtype=np.uint8)
    pixels[(cells >= 0) & (cells <= free_at_most)] = PIXEL_FREE
    pixels[cells >= occupied_at_least] = PIXEL_OCCUPIED
    return pixels
