"""Where cars drive: the place, its road, lines and goals along it."""
