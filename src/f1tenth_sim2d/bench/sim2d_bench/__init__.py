"""Benchmarks of the simulator: `make bench`. A module under keys/ measures one key, or a few."""
