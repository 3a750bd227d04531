"""unspawner: stops controllers, and starts them again when it ends."""

import rospy

from . import controller_manager_interface as manager
from .command_line import unspawner_parser


def main():
    """Run; return the exit code."""
    options = unspawner_parser().parse_args(rospy.myargv()[1:])
    if options.namespace:
        manager.MANAGER = f"{options.namespace.rstrip('/')}/controller_manager"
    rospy.init_node("unspawner", anonymous=True)
    if not manager.stop_controllers(options.controllers):
        return 1
    rospy.on_shutdown(lambda: manager.start_controllers(options.controllers))
    rospy.spin()
    return 0
