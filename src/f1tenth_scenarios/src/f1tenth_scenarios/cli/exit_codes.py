"""How the command ends."""

from f1tenth_scenarios.stop_request import StopRequest

PASSED, NOT_PASSED, BAD_INPUT = 0, 1, 2


def exit_code(passed: bool, stop: StopRequest) -> int:
    """Of a command that has run to its end, or was told to stop."""
    if stop.signal:
        return 128 + stop.signal
    return PASSED if passed else NOT_PASSED
