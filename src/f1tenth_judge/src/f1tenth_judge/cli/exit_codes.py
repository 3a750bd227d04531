"""How the command ends."""

import os
import sys
from typing import NoReturn

from f1tenth_judge.stop_request import StopRequest

PASSED, NOT_PASSED, BAD_INPUT = 0, 1, 2
_SIGNALLED = 128  # plus the number of the signal


def exit_code(passed: bool, stop: StopRequest) -> int:
    """Of a command that has run to its end, or was told to stop."""
    if stop.signal:
        return _SIGNALLED + stop.signal
    return PASSED if passed else NOT_PASSED


def leave(code: int) -> NoReturn:
    """End the process; at once if it was told to stop, whatever another thread still imports or draws."""
    if code > _SIGNALLED:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
    sys.exit(code)
