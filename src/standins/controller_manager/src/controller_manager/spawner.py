"""spawner: loads and starts controllers, and takes them away when it ends."""

import rosgraph
import rospy
from controller_manager_msgs.srv import (
    LoadController,
    LoadControllerRequest,
    SwitchController,
    SwitchControllerRequest,
    UnloadController,
)
from std_msgs.msg import Bool

from .command_line import spawner_parser

EXIT_NO_MANAGER = 1
EXIT_NOT_LOADED = 2


class Spawner:
    """Some controllers of one controller manager."""

    def __init__(self, namespace, timeout):
        """timeout: wall s for the controller manager; None: for ever.

        Raises:
            rospy.ROSException: it has not come.
        """
        prefix = f"{namespace.rstrip('/')}/" if namespace else ""
        services = {
            "load_controller": LoadController,
            "unload_controller": UnloadController,
            "switch_controller": SwitchController,
        }
        self._names = {service: f"{prefix}controller_manager/{service}" for service in services}
        for name in self._names.values():
            rospy.wait_for_service(name, timeout)
        self._call = {
            service: rospy.ServiceProxy(self._names[service], kind) for service, kind in services.items()
        }
        self._loaded = []

    def load(self, controllers):
        """Load them; return whether all could be."""
        for name in controllers:
            if self._call["load_controller"](LoadControllerRequest(name)).ok:
                rospy.loginfo("Loading controller: %s", name)
                self._loaded.append(name)
            else:
                rospy.logerr("Failed to load %s", name)
        return len(self._loaded) == len(controllers)

    def start(self):
        """Start what was loaded; return whether it worked."""
        return self._switch(self._loaded, [])

    def _switch(self, start, stop):
        request = SwitchControllerRequest(start_controllers=start, stop_controllers=stop)
        request.strictness = SwitchControllerRequest.STRICT
        return self._call["switch_controller"](request).ok

    def take_away(self, timeout):
        """Stop and unload what was loaded, if the controller manager answers within timeout, wall s.

        One that has ended has taken its controllers along.
        """
        if not self._loaded or not all(map(self._is_there, self._names.values())):
            return
        try:
            for name in self._names.values():
                rospy.wait_for_service(name, timeout)
            self._switch([], self._loaded)
            for name in reversed(self._loaded):
                self._call["unload_controller"](name)
        except (rospy.ROSException, rospy.ServiceException) as error:
            if self._is_there(self._names["unload_controller"]):
                rospy.logwarn("Controllers were left behind: %s", error)

    @staticmethod
    def _is_there(service):
        try:
            rosgraph.Master(rospy.get_name()).lookupService(rospy.resolve_name(service))
        except (rosgraph.MasterException, OSError):
            return False
        return True


def wait_for_go(topic):
    """Block until a true Bool comes on a topic."""
    while not rospy.is_shutdown():
        if rospy.wait_for_message(topic, Bool).data:
            return


def main():
    """Run; return the exit code."""
    rospy.init_node("spawner", anonymous=True)
    options = spawner_parser().parse_args(rospy.myargv()[1:])
    try:
        spawner = Spawner(options.namespace, options.timeout)
    except rospy.ROSException:
        rospy.logerr("No controller manager within %s s. Its name is controller_manager/...", options.timeout)
        return EXIT_NO_MANAGER
    rospy.on_shutdown(lambda: spawner.take_away(options.shutdown_timeout))
    complete = spawner.load(options.controllers)
    if options.wait_for:
        wait_for_go(options.wait_for)
    if not options.stopped and not spawner.start():
        rospy.logerr("Failed to start controllers: %s", ", ".join(options.controllers))
        return EXIT_NOT_LOADED
    rospy.loginfo("Started controllers: %s", ", ".join(options.controllers))
    rospy.spin()
    return 0 if complete else EXIT_NOT_LOADED
