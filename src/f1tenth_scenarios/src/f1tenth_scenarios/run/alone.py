"""A run with ROS on a master of its own: what f1tenth_judge offers where this package is installed."""

import contextlib

from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.results.result import Result
from f1tenth_judge.run.loop import Progress
from f1tenth_judge.stop_request import StopRequest


def run_alone(plan: Plan, stop: StopRequest, progress: Progress) -> Result:
    """As run_with_ros, on a private master; a plan that is watched, on the one that runs.

    Raises:
        ScenarioError: the results folder cannot be used, or the master does not start.
    """
    from f1tenth_scenarios.launch.private_master import private_master
    from f1tenth_scenarios.run.ros_session import run_with_ros

    with contextlib.nullcontext() if plan.watched else private_master():
        return run_with_ros(plan, stop, progress)
