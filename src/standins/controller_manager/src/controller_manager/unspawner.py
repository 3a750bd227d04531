"""unspawner: stops controllers, and starts them again when it ends."""

import rospy

from . import controller_manager_interface as manager
from .command_line import unspawner_parser
from .ending import Ending

STOP_TIMEOUT = 5.0  # wall s for the controller manager to answer once the end has begun
RESTART_TIMEOUT = 1.0  # wall s for the controller manager at the end: it may be gone


def start_again(controllers):
    """Start the controllers that were stopped, if there were any."""
    if not controllers:
        return
    try:
        manager.start_controllers(controllers, RESTART_TIMEOUT)
    except (rospy.ROSException, rospy.ServiceException) as error:
        rospy.logwarn("Controllers were not started again: %s", error)


def stop(controllers, stopped, ending):
    """Stop controllers, which are then in `stopped`: the end may come meanwhile. Return whether it worked."""
    with ending.working:
        if ending.has_begun:
            return True
        if not manager.stop_controllers(controllers):
            return False
        stopped.extend(controllers)
        return True


def main():
    """Run; return the exit code."""
    options = unspawner_parser().parse_args(rospy.myargv()[1:])
    if options.namespace:
        manager.use_namespace(options.namespace)
    rospy.init_node("unspawner", anonymous=True, disable_signals=True)
    ending = Ending(STOP_TIMEOUT)
    stopped = []
    rospy.on_shutdown(lambda: start_again(stopped))
    try:
        rospy.wait_for_service(manager.service_name("switch_controller"))
        if not stop(options.controllers, stopped, ending):
            return 1
    except (rospy.ROSException, rospy.ServiceException) as error:
        if ending.has_begun:
            return 0
        rospy.logerr("Controllers were not stopped: %s", error)
        return 1
    rospy.spin()
    return 0
