"""Being told to stop: a flag instead of an exception, so that what was begun is ended in order."""

import contextlib
import signal
from collections.abc import Iterator
from typing import Optional

_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class StopRequest:
    """Whether a signal asked this process to end, and which."""

    def __init__(self):
        self.signal: Optional[signal.Signals] = None

    @contextlib.contextmanager
    def listening(self) -> Iterator["StopRequest"]:
        """Take SIGINT, SIGTERM and SIGHUP as requests while the block runs. For the main thread only."""
        before = {number: signal.signal(number, self._take) for number in _SIGNALS}
        try:
            yield self
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)

    def _take(self, number, _frame):
        self.signal = signal.Signals(number)
