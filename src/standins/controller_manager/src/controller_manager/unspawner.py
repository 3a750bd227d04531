"""unspawner: stops controllers, and starts them again when it ends."""

import rospy

from . import controller_manager_interface as manager
from .command_line import unspawner_parser

RESTART_TIMEOUT = 1.0  # wall s for the controller manager at the end: it may be gone


def start_again(controllers):
    """Start the controllers that were stopped, if there were any."""
    if not controllers:
        return
    try:
        manager.start_controllers(controllers, RESTART_TIMEOUT)
    except (rospy.ROSException, rospy.ServiceException) as error:
        rospy.logwarn("Controllers were not started again: %s", error)


def main():
    """Run; return the exit code."""
    options = unspawner_parser().parse_args(rospy.myargv()[1:])
    if options.namespace:
        manager.use_namespace(options.namespace)
    rospy.init_node("unspawner", anonymous=True)
    # Before they are stopped: a signal may come as soon as they are.
    stopped = list(options.controllers)
    rospy.on_shutdown(lambda: start_again(stopped))
    if not manager.stop_controllers(options.controllers):
        stopped.clear()
        return 1
    rospy.spin()
    return 0
