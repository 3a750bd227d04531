"""Waiting for what other processes do."""

import time

PATIENCE = 120.0  # wall s: only a hang takes that long


def wait_for(condition):
    """Return the value of a condition as soon as it is true."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        value = condition()
        if value:
            return value
        time.sleep(0.01)
    raise AssertionError("waited in vain")
