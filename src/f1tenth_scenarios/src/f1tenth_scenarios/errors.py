"""The exceptions of this package."""


class ScenarioError(Exception):
    """What the user asked for cannot be done; the message is one line: where, what, what is allowed."""


class NotApplicableError(ScenarioError):
    """A scenario says nothing about the planner that it is to be run with; the message says why."""


class MisfitError(Exception):
    """A car's driver turned out not to fit lockstep; the message says which and why."""
