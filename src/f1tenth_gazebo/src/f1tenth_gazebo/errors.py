"""What this package raises for a user's mistake."""


class FileError(Exception):
    """A file is not as it must be; one line: FILE:LINE or FILE, place, what was found, what is allowed."""


class CircuitError(FileError):
    """A circuit that cannot be built; one line: its name, place, what was found, what is allowed."""


class MapError(FileError):
    """A file is not a map; the text is one line that names it."""
