"""Answering each scan with the odometry of its time, though the two come over different connections."""

import threading
from typing import Any, Callable, Optional

from f1tenth_judge.record.record import STAMP_EPSILON


class Answering:
    """Calls back once per scan, as soon as the newest odometry up to its stamp is there; from any thread."""

    def __init__(self, answer: Callable[[float, Any], None], odometry_period: float):
        """`answer` gets the scan's stamp (s) and the odometry; `odometry_period` in s."""
        self._answer = answer
        self._period = odometry_period
        self._lock = threading.Lock()
        self._waiting: Optional[float] = None
        self._newest: Optional[tuple[float, Any]] = None

    def take_scan(self, stamp: float) -> None:
        """A scan was taken (s)."""
        with self._lock:
            self._waiting = stamp
            self._answer_if_ready()

    def take_odometry(self, stamp: float, odometry: Any) -> None:
        """An odometry has come (s)."""
        with self._lock:
            self._newest = stamp, odometry
            self._answer_if_ready()

    def _answer_if_ready(self) -> None:
        if self._waiting is None or self._newest is None:
            return
        stamp, odometry = self._newest
        if stamp <= self._waiting - self._period + STAMP_EPSILON:
            return  # a newer one is still to come
        waiting, self._waiting = self._waiting, None
        self._answer(waiting, odometry)
