"""What a scenario wants to happen during a run: nodes that are killed, models that are pushed."""
