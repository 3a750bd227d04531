"""How fast simulated time passes."""

from typing import Optional


class Pace:
    """The real-time factor of a run, from the first to the last period seen; starting up does not count."""

    def __init__(self):
        self._first: Optional[tuple[float, float]] = None
        self._last: Optional[tuple[float, float]] = None

    def note(self, simulated: Optional[float], wall: float) -> None:
        """Simulated time (s, nothing before the first period) as it is at a wall time (s)."""
        if simulated is None or (self._last and simulated <= self._last[0]):
            return
        self._first = self._first or (simulated, wall)
        self._last = (simulated, wall)

    def standing(self, wall: float) -> float:
        """For how long (wall s) simulated time has stood still, at a wall time (s)."""
        return wall - (self._last[1] if self._last else 0.0)

    @property
    def factor(self) -> Optional[float]:
        """Simulated seconds per wall second; nothing until two moments are known."""
        if self._first is None or self._last is None or self._last[1] <= self._first[1]:
            return None
        return (self._last[0] - self._first[0]) / (self._last[1] - self._first[1])
