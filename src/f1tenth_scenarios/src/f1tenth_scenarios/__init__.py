"""Scenarios for the F1/10 car: describe a test case, run it in the simulator, judge it, write its results."""
