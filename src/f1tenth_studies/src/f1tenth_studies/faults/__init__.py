"""What breaks in a run, and how the run reacts: the command `faults`."""
