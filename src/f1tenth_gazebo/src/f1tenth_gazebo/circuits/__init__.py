"""Circuits: what one consists of, its file, its centreline, one lap along it."""
