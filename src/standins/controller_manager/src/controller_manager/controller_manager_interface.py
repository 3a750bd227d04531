"""The services of a controller manager as functions that print the outcome and return success."""

import rosgraph
import rospy
from controller_manager_msgs.srv import (
    ListControllers,
    ListControllerTypes,
    LoadController,
    ReloadControllerLibraries,
    SwitchController,
    SwitchControllerRequest,
    UnloadController,
)

_manager = "controller_manager"


def use_namespace(namespace):
    """Talk to the controller manager of another namespace from now on."""
    global _manager
    _manager = f"{namespace.rstrip('/')}/controller_manager"


def manager_name():
    """Full name of the controller manager."""
    return rospy.resolve_name(_manager)


def managers():
    """Return the full names of all controller managers that there are."""
    services = rosgraph.Master(rospy.get_name()).getSystemState()[2]
    mark = "/controller_manager/load_controller"
    return sorted(name.rpartition("/")[0] for name, _ in services if name.endswith(mark))


def service_name(service):
    """Full name of a service of the controller manager."""
    return f"{_manager}/{service}"


def call(service, kind, *arguments, timeout=None):
    """Call a service of the controller manager of this namespace.

    Raises:
        rospy.ROSException: it did not appear within the timeout, wall s.
        rospy.ServiceException: it failed.
    """
    name = service_name(service)
    rospy.wait_for_service(name, timeout)
    return rospy.ServiceProxy(name, kind)(*arguments)


def list_controllers():
    """Print what is loaded."""
    states = call("list_controllers", ListControllers).controller
    if not states:
        print("No controllers are loaded in mechanism control")
    for state in states:
        print(f"'{state.name}' - '{state.type}' ( {state.state} )")
    return True


def list_controller_types():
    """Print what can be loaded."""
    answer = call("list_controller_types", ListControllerTypes)
    for name, base_class in zip(answer.types, answer.base_classes):
        print(f"'{name}' ( {base_class} )")
    return True


def load_controller(name):
    """Load a controller; its type is in the parameter NAME/type."""
    return _say(
        call("load_controller", LoadController, name).ok, f"Loaded '{name}'", f"Error when loading '{name}'"
    )


def unload_controller(name):
    """Unload a controller that does not run."""
    ok = call("unload_controller", UnloadController, name).ok
    return _say(ok, f"Unloaded '{name}' successfully", f"Error when unloading '{name}'")


def switch_controllers(start, stop, timeout=None):
    """Start and stop controllers at the same time, all or none; return whether it worked.

    Raises:
        as call.
    """
    request = (list(start), list(stop), SwitchControllerRequest.STRICT, False, 0.0)
    return call("switch_controller", SwitchController, *request, timeout=timeout).ok


def start_controllers(names, timeout=None):
    """Start loaded controllers.

    Raises:
        as call.
    """
    shown = ", ".join(names)
    return _say(
        switch_controllers(names, [], timeout),
        f"Started {shown} successfully",
        f"Error when starting {shown}",
    )


def stop_controllers(names):
    """Stop running controllers."""
    shown = ", ".join(names)
    return _say(
        switch_controllers([], names), f"Stopped {shown} successfully", f"Error when stopping {shown}"
    )


def reload_libraries(force_kill=False):
    """Forget all controllers; only with force_kill if there are any."""
    ok = call("reload_controller_libraries", ReloadControllerLibraries, force_kill).ok
    return _say(ok, "Reloaded libraries", "Error when reloading libraries")


def _say(ok, good, bad):
    print(good if ok else bad)
    return ok
