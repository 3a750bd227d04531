"""Which number to announce when."""

SECOND = 1_000_000_000  # ns


class Countdown:
    """Counts whole seconds down to 0, from the first valid time that it sees.

    Knows no clock: it is told the time, in integer nanoseconds, so that a second is exactly a second.
    """

    def __init__(self, seconds):
        """Start at seconds (s, a whole number >= 0)."""
        self._seconds = seconds
        self._start = None
        self._last = 0
        self._announced = 0

    @property
    def finished(self):
        """Whether the 0 has been announced."""
        return self._announced > self._seconds

    def update(self, now):
        """Return the seconds left that are due by now (ns, 0: there is no clock yet), each of them once.

        More than one where the clock leapt over some. A clock that goes back (the simulation was reset)
        begins the countdown anew.
        """
        if now <= 0 or self.finished:
            return []
        if self._start is None or now < self._last:
            self._start, self._announced = now, 0
        self._last = now
        due_count = min((now - self._start) // SECOND, self._seconds) + 1
        due = [self._seconds - i for i in range(self._announced, due_count)]
        self._announced = max(self._announced, due_count)
        return due
