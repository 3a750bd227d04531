"""A run of a scenario with ROS around it."""

import logging
import os
from pathlib import Path
from typing import TYPE_CHECKING

import rospkg
from f1tenth_judge.errors import MismatchError
from f1tenth_judge.plan.pins import variables_of
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.plan.planning import in_real_time
from f1tenth_judge.results.result import Result
from f1tenth_judge.run.processes import process_start
from f1tenth_judge.scenario.interventions import DIRECTOR
from f1tenth_judge.stop_request import StopRequest

from f1tenth_scenarios.launch.launch_file import launch_command
from f1tenth_scenarios.run.run import execute
from f1tenth_scenarios.run.supervisor import Progress

if TYPE_CHECKING:
    from f1tenth_scenarios.run.ros_watch import RosWatch

# Every line of a node's output names the node, so that its last words can be found among the others'.
_CONSOLE_FORMAT = "[${severity}] [${time}] [${node}]: ${message}"


def run_with_ros(plan: Plan, stop: StopRequest, progress: Progress = lambda simulated, wall: None) -> Result:
    """Run a scenario on the master that ROS_MASTER_URI names; once per process, from the main thread.

    If a driver does not fit lockstep, the run begins anew without lockstep, and the result says so.

    Raises:
        ScenarioError: the results folder cannot be used.
    """
    try:
        return _run(plan, stop, progress)
    except MismatchError as mismatch:
        return _run(in_real_time(plan, str(mismatch)), stop, progress)
    finally:
        _leave_ros()


def _run(plan: Plan, stop: StopRequest, progress: Progress) -> Result:
    environment = {
        "ROS_LOG_DIR": str(plan.log_folder),
        "ROSCONSOLE_FORMAT": _CONSOLE_FORMAT,
        "PYTHONUNBUFFERED": "1",
        "ROS_HOME": _ros_home(plan),
        **variables_of(plan.scenario, os.environ),
    }
    command = launch_command(plan.launch_file)
    return execute(plan, command, environment, lambda: _watch(plan), stop, progress, process_start())


def _ros_home(plan: Plan) -> str:
    """The folder in which roslaunch starts nodes: the usual one, unless it cannot be made (a full disk)."""
    usual = Path(rospkg.get_ros_home())
    try:
        usual.mkdir(parents=True, exist_ok=True)
    except OSError:
        return str(plan.log_folder)
    return str(usual)


def _watch(plan: Plan) -> "RosWatch":
    import rospy

    from f1tenth_scenarios.run.ros_watch import RosWatch

    # It would complain of nodes that ended while they asked something.
    logging.getLogger("xmlrpc").addHandler(logging.NullHandler())
    # Where the others log as well: rospy raises where it cannot make its file.
    os.environ["ROS_LOG_DIR"] = str(plan.log_folder)
    # Before anything sets use_sim_time, because this node lives in wall time. Not called as a rostest
    # is: pushes and answers count only from a node of this name.
    rospy.init_node(DIRECTOR, argv=[], disable_signals=True, disable_rosout=True)
    return RosWatch(plan)


def _leave_ros() -> None:
    import rospy

    rospy.signal_shutdown("the run is over")
