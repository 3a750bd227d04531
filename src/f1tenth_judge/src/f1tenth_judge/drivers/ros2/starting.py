"""How planners of ROS 2 are started, where PyPI's `cyclonedds` may be missing."""

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.run.execute import Drivers


def drivers_on_dds() -> Drivers:
    """What starts them.

    Raises:
        ScenarioError: cyclonedds is not installed.
    """
    try:
        from f1tenth_judge.drivers.ros2.driver import ros2_drivers
    except ImportError as error:
        why = f"planners of ROS 2 need cyclonedds from PyPI ({error})"
        raise ScenarioError(f"{why}; install it with `pip install 'cyclonedds>=11.0'`") from error
    return ros2_drivers
