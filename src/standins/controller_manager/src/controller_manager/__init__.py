"""Loads, starts, stops and unloads joint controllers."""
