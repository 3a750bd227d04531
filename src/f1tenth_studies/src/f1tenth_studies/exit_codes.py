"""How commands end."""

GOOD, NOT_GOOD, BAD_INPUT = 0, 1, 2
