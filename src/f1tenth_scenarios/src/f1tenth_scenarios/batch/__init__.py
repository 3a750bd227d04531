"""Many runs: repetitions, sweeps, their tables."""
