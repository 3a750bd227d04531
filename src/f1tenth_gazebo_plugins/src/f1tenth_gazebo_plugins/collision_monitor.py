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


def _next_multiple(time):
    return (time // REPORT_PERIOD + 1) * REPORT_PERIOD


class CollisionMonitor:
    """Joins the contact sensors of a car into one state and counts how often it began to touch something.

    sensors: their names.
    ground_models: names of models that a car may touch.
    """

    def __init__(self, sensors, ground_models=()):
        self._names = tuple(sensors)
        self._ground_models = frozenset(ground_models)
        self._clock = 0
        self._restart()

    def _restart(self):
        self._sensors = {name: _Sensor() for name in self._names}
        self._collision = False
        self._collisions = 0
        self._newest_stamp = 0
        self._next_report = 0
        self._next_tick = 0
        self._reported = False
        # Until the clock has followed the sensors into the new run, it is not to be believed.
        self._clock_of_old_run, self._clock = self._clock, 0

    def hear(self, name, stamp, contacts=()):
        """Take in one message of a sensor and return the Report that is due.

        contacts: for each contact the scoped names of the two collision elements.
        A stamp older than the sensor's last one begins a new run.
        """
        last_stamp = self._sensors[name].last_stamp
        if last_stamp is not None and stamp < last_stamp:
            self._restart()
        sensor = self._sensors[name]
        sensor.last_stamp = stamp
        sensor.touching = any(not self._with_ground(pair) for pair in contacts)
        # Sensors are read one after the other: a stamp may be a little older than the newest.
        self._newest_stamp = max(stamp, self._newest_stamp)
        due = self._newest_stamp >= self._next_report
        if due:
            self._next_report = _next_multiple(self._newest_stamp)
            self._next_tick = self._next_report + REPORT_PERIOD
        return self._update(due)

    def tick(self, clock):
        """Let time pass without a message; return the Report that is due unless the sensors see to it."""
        if self._clock_of_old_run and self._newest_stamp < self._clock_of_old_run <= clock:
            return Report()
        self._clock_of_old_run = 0
        self._clock = clock
        due = clock >= self._next_tick
        if due:
            self._next_tick = _next_multiple(clock)
        return self._update(due)

    def silent_sensors(self):
        """Map each sensor that says nothing to the ns since it last spoke, or to None if it never did."""
        now = max(self._clock, self._newest_stamp)
        silence = {
            name: None if sensor.last_stamp is None else now - sensor.last_stamp
            for name, sensor in self._sensors.items()
        }
        return {name: time for name, time in silence.items() if time is None or time > SILENCE_LIMIT}

    def _with_ground(self, pair):
        return any(name.split("::", 1)[0] in self._ground_models for name in pair)

    def _update(self, due):
        collision = any(sensor.touching for sensor in self._sensors.values())
        began = collision and not self._collision
        changed = collision != self._collision
        first, self._reported = not self._reported, True
        self._collision = collision
        self._collisions += began
        return Report(
            collision=collision if due or changed or first else None,
            collisions=self._collisions if began or first else None,
        )
