"""Driving without a map: the node that takes a car around once, and driving by hand."""
