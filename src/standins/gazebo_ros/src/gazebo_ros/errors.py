"""What a user can do wrong."""


class UsageError(Exception):
    """One line for the user."""
