"""A planner that is a Python class, as the driver of a car."""

import contextlib
import multiprocessing
import os
import struct
import sys
import time
from pathlib import Path
from typing import Any, Optional

import numpy as np

import f1tenth_sim2d
from f1tenth_judge.drivers.python import process
from f1tenth_judge.drivers.python.pictures import PictureMemory
from f1tenth_judge.plan.hand_off import given_arguments, offered_arguments
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.planner import Observation, Scan
from f1tenth_judge.record.observations import Failure
from f1tenth_judge.run.command_watch import CommandCount, CommandWatch
from f1tenth_judge.run.log_excerpt import exception_in, last_lines, quoted
from f1tenth_judge.run.processes import ProcessTree
from f1tenth_judge.run.stage import DriveCommand, Stage
from f1tenth_judge.said import notes
from f1tenth_judge.stop_request import StopRequest

_GRACE = 1.0  # wall s, to end after SIGINT
_LOOK_INTERVAL = 0.05  # wall s, between two looks whether it has ended
_END_INTERVAL = 1.0  # wall s, in which a process ends that has closed its pipe
_COUNT_INTERVAL = 1.0  # simulated s, between two looks at the commands


class PythonDriver:
    """Runs a planner in a process of its own, and asks it once per period."""

    def __init__(self, plan: Plan, stage: Stage, car: str, stop: StopRequest):
        """Start the process of a car's planner; its output goes to CAR.log in the plan's log folder."""
        self._stage, self._car, self._limits, self._stop = stage, car, plan.scenario.limits, stop
        self._eyes = stage.eyes(car)
        self._info = {**_info(plan, car), "eyes": self._eyes}
        self._log = plan.log_folder / f"{car}.log"
        self._watch = CommandWatch([car], self._limits.silence)
        self._accepted, self._refused, self._refusal, self._counted = 0, 0, "", 0.0
        self._problem = ""
        self._has_looked = False
        self._pipe, theirs = multiprocessing.Pipe()
        with theirs, open(os.memfd_create("pictures"), "rb+", buffering=0) as memory:
            self._pictures = PictureMemory(memory.fileno(), self._eyes)
            command = [sys.executable, "-m", process.__name__, _planner_of(plan, car)]
            descriptors = {process.PIPE: theirs.fileno(), process.PICTURES: memory.fileno()}
            variables = {name: str(each) for name, each in descriptors.items()}
            variables["PYTHONUNBUFFERED"] = "1"
            self._tree = ProcessTree(command, self._log, variables, tuple(descriptors.values()))

    def begin(self) -> None:
        """Let it load; see Driver."""
        with self._noting_its_end():
            self._pipe.send(self._info)
            self._answer(self._limits.load, "load")

    def act(self, stage: Stage) -> None:
        """Let it handle a period; see Driver."""
        if self._problem:
            return
        with self._noting_its_end():
            self._pipe.send(observe(stage, self._car))
            answer = self._answer(self._limits.answer, "answer")
            if answer:
                self._obey(stage, DriveCommand(*process.ANSWER.unpack(answer)))

    def failure(self, time: float, is_done: bool) -> Optional[Failure]:
        """Why it is of no use; see Driver."""
        if self._problem and not is_done:
            return self._failed(self._problem, time)
        if time - self._counted >= _COUNT_INTERVAL:
            self._counted = time
            self._watch.take(CommandCount(time, self._car, self._accepted, self._refused, self._refusal))
        problems = self._watch.problems({self._car} if is_done else set())
        return self._failed(problems[0].text, problems[0].stamp) if problems else None

    def note(self) -> str:
        """What its cameras do not see as it is described; see Driver."""
        warning = self._stage.look_warning() if self._has_looked else ""
        return f"{self._car}: camera: {warning}" if warning else ""

    def close(self) -> None:
        """End its process, and all that it has started."""
        self._pipe.close()
        self._tree.stop(_GRACE)

    def _obey(self, stage: Stage, command: DriveCommand) -> None:
        try:
            stage.command(self._car, command)
            self._accepted += 1
        except f1tenth_sim2d.Error as error:
            self._refused, self._refusal = self._refused + 1, str(error)

    def _answer(self, patience: float, limit: str) -> bytes:
        """What it answers; empty if it does not within a time (wall s), or is told to stop."""
        deadline = time.monotonic() + patience
        while not (self._problem or self._stop.signal):
            if self._pipe.poll(_LOOK_INTERVAL):
                message = self._pipe.recv_bytes(len(process.NOTES) + notes.MOST)
                if len(message) == process.LOOK.size:
                    self._show(*process.LOOK.unpack(message))
                elif message.startswith(process.NOTES):
                    text = message[len(process.NOTES) :]
                    notes.keep(self._stage.said, self._car, self._stage.time, text)
                else:
                    return message
            elif self._tree.exit_code() is not None:  # a process that it has forked may keep the pipe open
                raise EOFError
            if time.monotonic() >= deadline:
                self._problem = f"has not answered within {patience:g} s of wall time (limits.{limit})"
        return b""

    def _show(self, index: int) -> None:
        """Let it see what an eye sees now."""
        if index >= len(self._eyes):
            self._problem = f"has asked for the eye {index}, and the car has {len(self._eyes)}"
            return
        eye = self._eyes[index]
        self._pictures.put(eye, self._stage.look(self._car, eye))
        self._pipe.send_bytes(process.LOOK.pack(index))
        self._has_looked = True

    @contextlib.contextmanager
    def _noting_its_end(self):
        """Note the end of its process, which closes the pipe."""
        try:
            yield
        except (EOFError, OSError):
            code = self._tree.wait(_END_INTERVAL)
            self._problem = "has closed its pipe" if code is None else f"ended with exit code {code}"
        except struct.error:
            self._problem = "has sent what is no answer"

    def _failed(self, reason: str, stamp: float) -> Failure:
        lines = last_lines(self._log)
        raised = exception_in(lines)
        why = f"{reason}; it raised {raised}" if raised else reason
        return Failure(f"{self._car}/planner", why, str(self._log), tuple(quoted(lines)), stamp)


def observe(stage: Stage, car: str) -> Observation:
    """What a car has sensed in the last period."""
    state = stage.states[car]
    samples = [sample for _, sample in stage.imu_samples(car)]
    return Observation(
        time=stage.time,
        scan=_scan(stage, car),
        pose=(state.x, state.y, state.yaw),
        velocity=(state.v_x, state.v_y, state.yaw_rate),
        steering_angle=state.steering_angle,
        imu=np.array([(each.a_x, each.a_y, each.yaw_rate) for each in samples]),
    )


def _scan(stage: Stage, car: str) -> Optional[Scan]:
    measured = stage.scan(car)
    if measured is None:
        return None
    lidar, ranges = measured
    increment = (lidar.angle_max - lidar.angle_min) / max(lidar.beam_count - 1, 1)
    # As precise as a LaserScan has them: a planner computes the same as in ROS.
    angles_and_ranges = (lidar.angle_min, increment, lidar.range_min, lidar.range_max)
    return Scan(ranges, *(float(np.float32(value)) for value in angles_and_ranges))


def _planner_of(plan: Plan, name: str) -> str:
    car = next(each for each in plan.scenario.cars if each.name == name)
    kind = car.driver.python.rpartition(":")[2]
    return f"{plan.cars[name].driver.path}:{kind}"


def _info(plan: Plan, name: str) -> dict[str, Any]:
    car = next(each for each in plan.scenario.cars if each.name == name)
    offered = {
        key: value for key, value in offered_arguments(plan, car).items() if not key.endswith("_topic")
    }
    told = {**offered, **given_arguments(plan, car)}
    return {key: str(value) if isinstance(value, Path) else value for key, value in told.items()}
