"""What planners saw, as small as a thumb."""

import base64
import io
from typing import Optional

from PIL import Image

_SIZE, _QUALITY = (160, 120), 60  # pixels, at most; of a JPEG
# Modes of Pillow, and the raw ones that messages have, by sensor_msgs/image_encodings.
_MODES = {
    "rgb8": ("RGB", "RGB"),
    "bgr8": ("RGB", "BGR"),
    "rgba8": ("RGB", "RGBX"),
    "bgra8": ("RGB", "BGRX"),
    "mono8": ("L", "L"),
    "8UC1": ("L", "L"),
    "8UC3": ("RGB", "BGR"),
}


def thumbnail(message) -> Optional[str]:
    """A sensor_msgs/Image or CompressedImage as JPEG in base64; nothing if it is no picture, as of depth."""
    picture = _compressed(message) if hasattr(message, "format") else _raw(message)
    return small(picture) if picture else None


def small(picture: Image.Image) -> str:
    """A picture as JPEG in base64."""
    picture.thumbnail(_SIZE)
    stream = io.BytesIO()
    picture.convert("RGB").save(stream, "JPEG", quality=_QUALITY)
    return base64.b64encode(stream.getvalue()).decode("ascii")


def _raw(message) -> Optional[Image.Image]:
    if message.encoding not in _MODES or not message.height * message.width:
        return None
    mode, raw = _MODES[message.encoding]
    size = (message.width, message.height)
    try:
        return Image.frombytes(mode, size, bytes(message.data), "raw", raw, message.step)
    except ValueError:  # fewer bytes than it says
        return None


def _compressed(message) -> Optional[Image.Image]:
    try:
        return Image.open(io.BytesIO(bytes(message.data))).convert("RGB")
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError):  # of compressed depth, or broken
        return None
