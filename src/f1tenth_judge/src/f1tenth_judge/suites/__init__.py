"""Suites: many cases of one scenario, for any planner."""
