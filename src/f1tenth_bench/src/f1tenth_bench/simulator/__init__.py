"""The simulator through its Python module: worlds, cars, laps, and what they cost."""
