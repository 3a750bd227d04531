"""Starting the drivers of a run without ROS 1, each of its kind."""

import contextlib

from f1tenth_judge.drivers.python.driver import PythonDriver
from f1tenth_judge.drivers.ros2.starting import drivers_on_dds
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.run.driver import Driver
from f1tenth_judge.run.outcome import track_map
from f1tenth_judge.run.stage import Stage
from f1tenth_judge.stop_request import StopRequest


def start_drivers(
    plan: Plan, stage: Stage, stop: StopRequest, stack: contextlib.ExitStack
) -> dict[str, Driver]:
    """The drivers of all cars by their names; see run.execute.Drivers."""
    return {
        car.name: stack.enter_context(contextlib.closing(_start(plan, stage, stop, car)))
        for car in plan.scenario.cars
    }


def _start(plan, stage, stop, car) -> Driver:
    if car.driver.python:
        return PythonDriver(plan, stage, car.name, stop)
    drivers_on_dds()  # says what is missing, if it is
    from f1tenth_judge.drivers.ros2.driver import Ros2Driver

    return Ros2Driver(plan, stage, car.name, track_map(plan), stop)
