"""Benchmarks of the simulator: `make bench`. One module under keys/ measures one key, or a few that go together."""
