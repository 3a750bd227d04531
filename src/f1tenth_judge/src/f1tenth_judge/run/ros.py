"""Runs whose planners are launch files of ROS 1: whoever can do them has an entry point."""

from typing import Callable, Optional

from f1tenth_judge.errors import NotApplicableError
from f1tenth_judge.extensions import extensions
from f1tenth_judge.plan.launched_nodes import check_nodes
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.results.result import Result
from f1tenth_judge.run.loop import Progress
from f1tenth_judge.stop_request import StopRequest

GROUP, ROS_1 = "f1tenth_judge.runners", "ros1"
Runner = Callable[[Plan, StopRequest, Progress], Result]

_REMEDY = (
    "source the devel/setup.bash of a workspace with f1tenth_scenarios, or name a planner that needs no ROS"
    " (--planner FILE.py:CLASS)"
)


def ros_runner() -> Optional[Runner]:
    """Runs a plan with ROS 1; None where that is not installed."""
    return extensions(GROUP).get(ROS_1)


def require_runner(plan: Plan) -> None:
    """Refuse a plan that cannot be run here.

    Raises:
        NotApplicableError: it needs ROS 1, which is not installed.
        ScenarioError: the launch file of a planner starts what is not there.
    """
    launched = [car for car in plan.scenario.cars if car.driver.launch]
    if launched and ros_runner() is None:
        why = f"{launched[0].name} is driven by a launch file of ROS 1 ({launched[0].driver.name})"
        raise NotApplicableError(f"{why}, which is not here; {_REMEDY}")
    for car in launched:
        if not car.driver.is_ours:
            check_nodes(plan.cars[car.name].driver.path)
