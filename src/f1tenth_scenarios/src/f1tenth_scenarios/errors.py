"""The exceptions of this package."""


class ScenarioError(Exception):
    """What the user asked for cannot be done; the message is one line: where, what, what is allowed."""
