"""What breaks in a run, and what the run makes of it: the command `faults`."""
