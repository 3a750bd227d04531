"""Reads a map's image into grid cells."""

import warnings

import numpy as np
from PIL import Image, UnidentifiedImageError

from map_server.errors import MapImageError
from map_server.occupancy import UNKNOWN, cells_from_brightness

# Pillow's way of holding an image -> how to make eight-bit channels of it.
_CONVERSIONS = {
    "1": "L",
    "L": "L",
    "LA": "RGBA",
    "P": "RGB",
    "PA": "RGBA",
    "RGB": "RGB",
    "RGBA": "RGBA",
    "I": "high byte",
    "I;16": "high byte",
    "I;16B": "high byte",
}


def read_cells(metadata):
    """Return the grid of a map's image: int8, row 0 is the bottom row of the image.

    Raises MapImageError naming the image.
    """
    channels = _read_channels(metadata.image)
    has_alpha = channels.shape[2] == 4
    # In trinary mode alpha counts like a colour: that is how existing maps have always been read.
    averaged = channels[:, :, :3] if has_alpha and metadata.mode != "trinary" else channels
    cells = _cells_from_sums(averaged.sum(axis=2, dtype=np.uint16), averaged.shape[2], metadata)
    if has_alpha and metadata.mode == "scale":
        transparent = (channels[:, :, 3] == 0) & (cells != 0) & (cells != 100)
        cells[transparent] = UNKNOWN
    return np.ascontiguousarray(cells[::-1])


def _cells_from_sums(sums, count, metadata):
    # Every possible sum is converted once, instead of every pixel.
    table = cells_from_brightness(np.arange(255 * count + 1) / float(count), metadata)
    return table[sums]


def _read_channels(path):
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            with Image.open(path) as image:
                return _eight_bit_channels(image, path)
    except UnidentifiedImageError as error:
        raise MapImageError(f"{path}: image: not an image file (PGM and PNG are usual)") from error
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        reason = getattr(error, "strerror", None) or error
        raise MapImageError(f"{path}: image: cannot be read: {reason}") from error


def _eight_bit_channels(image, path):
    conversion = _CONVERSIONS.get(image.mode)
    if conversion is None:
        raise MapImageError(
            f"{path}: image: pixels of kind {image.mode}, allowed are grey and RGB, with or without alpha"
        )
    if conversion == "high byte":
        array = (np.asarray(image).astype(np.int32) >> 8).astype(np.uint8)
    else:
        # The original's library gives every TIFF an alpha channel.
        if "transparency" in image.info or image.format == "TIFF":
            conversion = "RGBA"
        brightest = _brightest(image)
        array = _truncated(np.asarray(image.convert(conversion)), brightest)
    return array.reshape(array.shape[0], array.shape[1], -1)


def _brightest(image):
    """The greatest value that the pixels of a PGM or PPM file can have; 255 for other files."""
    return max((tile[3][1] for tile in image.tile if tile[0] in ("ppm", "ppm_plain")), default=255)


def _truncated(pixels, brightest):
    """Scaled to 255 as by the original's library, which truncates where Pillow rounds."""
    if brightest >= 255:
        return pixels
    values = np.rint(pixels * (brightest / 255.0)).astype(np.int32)
    return (values * 255 // brightest).astype(np.uint8)
