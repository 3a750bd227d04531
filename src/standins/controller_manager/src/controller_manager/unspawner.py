"""unspawner: stops controllers, and starts them again when it ends."""

import rospy

from . import controller_manager_interface as manager
from .command_line import unspawner_parser


def main():
    """Run; return the exit code."""
    options = unspawner_parser().parse_args(rospy.myargv()[1:])
    if options.namespace:
        manager.use_namespace(options.namespace)
    rospy.init_node("unspawner", anonymous=True)
    # Before they are stopped: a signal may come as soon as they are.
    stopped = list(options.controllers)
    rospy.on_shutdown(lambda: stopped and manager.start_controllers(stopped))
    if not manager.stop_controllers(options.controllers):
        stopped.clear()
        return 1
    rospy.spin()
    return 0
