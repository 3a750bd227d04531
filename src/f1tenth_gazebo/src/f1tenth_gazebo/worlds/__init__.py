"""Worlds: walls and openings as boxes, the SDF file, finding a world by name."""
