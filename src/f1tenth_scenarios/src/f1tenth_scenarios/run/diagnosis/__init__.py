"""Noticing that the set-up of a run broke, and who broke it."""
