"""Fixtures of several tests."""

from fake_scenario import program  # noqa: F401
