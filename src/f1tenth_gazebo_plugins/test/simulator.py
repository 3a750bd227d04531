"""Makes the simulator's own test tools importable: its process, its room, its car."""

import pathlib
import sys

import rospkg

sys.path.insert(
    0, str(pathlib.Path(rospkg.RosPack().get_path("f1tenth_sim2d")) / "test" / "node" / "process")
)

from sim2d_process import Collector, Driver, Sim2d, Stepper, car_description  # noqa: E402

__all__ = ["Collector", "Driver", "Sim2d", "Stepper", "car_description", "perfect_odometry"]


def perfect_odometry(**tags):
    """Return the plugin's element with some tags changed."""
    tags = {
        "alwaysOn": "true",
        "updateRate": "200.0",
        "odometryTopic": "perfect_odom",
        "odometryFrame": "odom",
        "robotBaseFrame": "base_footprint",
        "rosDebugLevel": "na",
        **tags,
    }
    content = "".join(f"<{tag}>{text}</{tag}>" for tag, text in tags.items())
    library = "libf1tenth_perfect_odometry.so"
    return f'<gazebo><plugin name="perfect_odometry" filename="{library}">{content}</plugin></gazebo>'
