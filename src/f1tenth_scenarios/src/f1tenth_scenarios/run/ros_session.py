"""A run of a scenario with ROS around it."""

from f1tenth_scenarios.launch.launch_file import launch_command
from f1tenth_scenarios.launch.processes import process_start
from f1tenth_scenarios.results.result import Result
from f1tenth_scenarios.run.run import execute
from f1tenth_scenarios.run.supervisor import Progress, Watch
from f1tenth_scenarios.scenario.plan import Plan
from f1tenth_scenarios.scenario.scenario import Scenario
from f1tenth_scenarios.stop_request import StopRequest

# Every line of a node's output names the node, so that its last words can be found among the others'.
_CONSOLE_FORMAT = "[${severity}] [${time}] [${node}]: ${message}"


def run_with_ros(plan: Plan, stop: StopRequest, progress: Progress = lambda simulated, wall: None) -> Result:
    """Run a scenario on the master that ROS_MASTER_URI names; once per process, from the main thread.

    Raises:
        ScenarioError: the results folder cannot be used.
    """
    environment = {
        "ROS_LOG_DIR": str(plan.log_folder),
        "ROSCONSOLE_FORMAT": _CONSOLE_FORMAT,
        "PYTHONUNBUFFERED": "1",
    }
    try:
        return execute(
            plan,
            launch_command(plan.launch_file),
            environment,
            lambda: _watch(plan.scenario),
            stop,
            progress,
            started=process_start(),
        )
    finally:
        _leave_ros()


def _watch(scenario: Scenario) -> Watch:
    import rospy

    from f1tenth_scenarios.run.ros_watch import RosWatch

    # Before anything sets use_sim_time, because this node lives in wall time.
    rospy.init_node("scenario", anonymous=True, disable_signals=True, disable_rosout=True)
    return RosWatch(scenario)


def _leave_ros() -> None:
    import rospy

    rospy.signal_shutdown("the run is over")
