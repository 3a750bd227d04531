"""Whether a car touches anything, from what its contact sensors say. No ROS; times are whole nanoseconds."""

from __future__ import annotations

from dataclasses import dataclass

SECOND = 1_000_000_000
SILENCE_LIMIT = SECOND
REPORT_PERIOD = SECOND // 10


@dataclass
class Report:
    """What is to be published now; nothing where it is None."""

    collision: bool | None = None
    collisions: int | None = None


@dataclass
class _Sensor:
    last_stamp: int | None = None
    touching: bool = False


class CollisionMonitor:
    """Joins the contact sensors of a car into one state and counts how often it began to touch something.

    sensors: their names.
    ground_models: names of models that a car may touch.
    """

    def __init__(self, sensors, ground_models=()):
        self._names = tuple(sensors)
        self._ground_models = frozenset(ground_models)
        self._restart()

    def _restart(self):
        self._sensors = {name: _Sensor() for name in self._names}
        self._collision = False
        self._collisions = 0
        self._now = None
        self._clock = None
        self._next_report = 0

    def hear(self, name, stamp, contacts=()):
        """Take in one message of a sensor and return the Report that is due.

        contacts: for each contact the scoped names of the two collision elements.
        A stamp older than the sensor's last one begins a new run.
        """
        sensor = self._sensors[name]
        if sensor.last_stamp is not None and stamp < sensor.last_stamp:
            self._restart()
            sensor = self._sensors[name]
        sensor.last_stamp = stamp
        sensor.touching = any(not self._with_ground(pair) for pair in contacts)
        return self._report(stamp)

    def tick(self, now):
        """Let time pass without a message and return the Report that is due."""
        if self._clock is not None and now < self._clock:
            self._follow_sensors(now)
        self._clock = now
        return self._report(now) if self._now is None or now > self._now else Report()

    def _follow_sensors(self, now):
        # The clock of the old run may have been read once more after the first message of the new one.
        stamps = [sensor.last_stamp for sensor in self._sensors.values() if sensor.last_stamp is not None]
        self._now = max(stamps, default=now)
        self._next_report = 0

    def silent_sensors(self):
        """Map each sensor that says nothing to the ns since it last spoke, or to None if it never did."""
        silence = {
            name: None if sensor.last_stamp is None else (self._now or 0) - sensor.last_stamp
            for name, sensor in self._sensors.items()
        }
        return {name: time for name, time in silence.items() if time is None or time > SILENCE_LIMIT}

    def _with_ground(self, pair):
        return any(name.split("::", 1)[0] in self._ground_models for name in pair)

    def _report(self, now):
        first = self._now is None
        # Sensors are read one after the other: a stamp may be a little older than the newest.
        self._now = now if first else max(now, self._now)
        collision = any(sensor.touching for sensor in self._sensors.values())
        changed = collision != self._collision
        self._collision = collision
        self._collisions += changed and collision
        due = first or changed or self._now >= self._next_report
        if due:
            self._next_report = (self._now // REPORT_PERIOD + 1) * REPORT_PERIOD
        return Report(
            collision=collision if due else None,
            collisions=self._collisions if first or (changed and collision) else None,
        )
