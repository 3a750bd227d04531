"""What this package raises for a user's mistake."""


class CircuitError(Exception):
    """A circuit that cannot be built; one line: file, place, what was found, what is allowed."""


class MapError(Exception):
    """A file is no map; the text is one line that names it."""
