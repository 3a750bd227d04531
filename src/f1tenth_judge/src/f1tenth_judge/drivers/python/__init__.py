"""Planners that are Python classes, each in a process of its own."""
