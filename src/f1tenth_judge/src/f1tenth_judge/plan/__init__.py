"""A scenario with everything that it names found and read: ready to run."""
