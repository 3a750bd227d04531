"""spawner: loads and starts controllers, and takes them away when it ends."""

import time

import rosgraph
import rospy
from controller_manager_msgs.srv import LoadController, UnloadController
from std_msgs.msg import Bool

from . import controller_manager_interface as manager
from .command_line import spawner_parser
from .ending import Ending

EXIT_NO_MANAGER = 1
EXIT_NOT_LOADED = 2
POLL_PERIOD = 0.05  # wall s
SERVICES = ("load_controller", "unload_controller", "switch_controller")


def wait_for_manager(timeout):
    """Block until the controller manager answers.

    Args:
        timeout: wall s for each of its services; None: for ever.

    Raises:
        rospy.ROSException: it did not appear.
    """
    for service in SERVICES:
        rospy.wait_for_service(manager.service_name(service), timeout)


def load(controllers, loaded, ending):
    """Load controllers, each of which is then appended to loaded: the end may come meanwhile."""
    for name in controllers:
        with ending.working:
            if ending.has_begun:
                return
            if manager.call("load_controller", LoadController, name).ok:
                rospy.loginfo("Loading controller: %s", name)
                loaded.append(name)
            else:
                rospy.logerr("Failed to load %s", name)


def take_away(loaded, timeout):
    """Stop and unload what was loaded, if the controller manager answers within timeout, wall s.

    A manager that has ended has taken them along; one that is ending has as long once more to be gone.
    """
    if not loaded or not all(map(_is_there, SERVICES)):
        return
    try:
        wait_for_manager(timeout)
        manager.switch_controllers([], loaded)
        for name in reversed(loaded):
            manager.call("unload_controller", UnloadController, name, timeout=timeout)
    except (rospy.ROSException, rospy.ServiceException) as error:
        if not _ends_within(timeout):
            rospy.logwarn("Controllers were left behind: %s", error)


def _ends_within(timeout):
    end = time.monotonic() + timeout
    while _is_there("unload_controller"):
        if time.monotonic() > end:
            return False
        time.sleep(POLL_PERIOD)
    return True


def _is_there(service):
    try:
        rosgraph.Master(rospy.get_name()).lookupService(rospy.resolve_name(manager.service_name(service)))
    except (rosgraph.MasterException, OSError):
        return False
    return True


def wait_for_go(topic):
    """Block until a true Bool comes on a topic."""
    while not rospy.is_shutdown():
        if rospy.wait_for_message(topic, Bool).data:
            return


def run(options, ending):
    """Load and start controllers, and wait for the end; return the exit code."""
    if not all(map(_is_there, SERVICES)):
        rospy.loginfo("Waiting for %s", manager.manager_name())
    try:
        wait_for_manager(options.timeout)
    except rospy.ROSException:
        if ending.has_begun:
            raise
        rospy.logerr(
            "No controller manager %s within %g s; there are: %s",
            manager.manager_name(),
            options.timeout,
            ", ".join(manager.managers()) or "none",
        )
        return EXIT_NO_MANAGER
    loaded = []
    rospy.on_shutdown(lambda: take_away(loaded, options.shutdown_timeout))
    load(options.controllers, loaded, ending)
    if ending.has_begun:
        return 0
    if options.wait_for:
        wait_for_go(options.wait_for)
    if loaded and not options.stopped:
        if not manager.switch_controllers(loaded, []):
            rospy.logerr("Failed to start controllers: %s", ", ".join(loaded))
            return EXIT_NOT_LOADED
        rospy.loginfo("Started controllers: %s", ", ".join(loaded))
    rospy.spin()
    return 0 if len(loaded) == len(options.controllers) else EXIT_NOT_LOADED


def main():
    """Run; return the exit code."""
    options = spawner_parser().parse_args(rospy.myargv()[1:])
    rospy.init_node("spawner", anonymous=True, disable_signals=True)
    if options.namespace:
        manager.use_namespace(options.namespace)
    ending = Ending(options.shutdown_timeout)
    try:
        return run(options, ending)
    except (rospy.ROSException, rospy.ServiceException):
        if ending.has_begun:
            return 0
        raise
