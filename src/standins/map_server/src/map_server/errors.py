"""What is thrown for a user's mistake."""


class MapError(Exception):
    """Base of all errors of this package; the text is one line for the user."""


class MapNotFoundError(MapError):
    """The map's YAML file is not there or cannot be opened."""


class MapMetadataError(MapError):
    """The YAML file is there, but a key is missing or has a wrong value."""

    def __init__(self, file, key, reason):
        super().__init__(f"{file}: {key}: {reason}" if key else f"{file}: {reason}")


class MapImageError(MapError):
    """The image that the YAML file names cannot be used."""


class MapSaveError(MapError):
    """A map cannot be written, or is not one that a file can hold."""
