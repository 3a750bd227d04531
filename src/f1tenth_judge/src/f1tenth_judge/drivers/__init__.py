"""Who drives a car: planners of others, and what stands in for them in lockstep."""
