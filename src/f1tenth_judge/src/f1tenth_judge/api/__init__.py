"""Races and scenarios from Python, as the command `f1tenth` runs them."""
