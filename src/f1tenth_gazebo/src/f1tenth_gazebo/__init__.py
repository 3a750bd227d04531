"""Circuits: from a centreline to a world, a map and goals."""
