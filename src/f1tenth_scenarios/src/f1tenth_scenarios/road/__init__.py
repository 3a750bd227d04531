"""What is driven on: the place, its road, lines and goals along it."""
