"""Benchmarks of simulator, planner and scenarios: `make bench`. The modules under keys/ measure."""
