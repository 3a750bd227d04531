"""pytest runs scenarios: those in YAML files as items, others by the fixture `f1tenth`."""
