"""Fixtures of several tests; its folder is where the tests below find the samples."""

from fake_scenario import program  # noqa: F401
