"""gzserver: sets the simulator's parameters from the command line and becomes the simulator."""

import os
import sys

import rosgraph.names
import rospkg
import rospy

from . import server_options
from .errors import UsageError
from .pace import real_time_factor

DEFAULT_NAME = "gazebo"
USAGE_EXIT_CODE = 2


def node_name(arguments):
    """Return the full name of the node, as remappings and ROS_NAMESPACE have it."""
    mappings = rospy.names.load_mappings(arguments)
    namespace = mappings.get("__ns", rosgraph.names.get_ros_namespace())
    return rosgraph.names.ns_join(
        rosgraph.names.make_global_ns(namespace), mappings.get("__name", DEFAULT_NAME)
    )


def executable():
    """Path of the simulator.

    Raises:
        UsageError: it has not been built.
    """
    for prefix in os.environ.get("CMAKE_PREFIX_PATH", "").split(":"):
        path = os.path.join(prefix, "lib", "f1tenth_sim2d", "sim2d")
        if os.access(path, os.X_OK):
            return path
    raise UsageError("no executable sim2d of f1tenth_sim2d below CMAKE_PREFIX_PATH: build the workspace")


def set_parameters(name, options):
    """Set what the command line gives; other parameters of the tree are the user's.

    Args:
        name: of the node.
        options: of server_options.parse.
    """
    tree = f"{name}/sim2d"
    share = rospkg.RosPack().get_path("gazebo_ros")
    folders = server_options.resource_folders(os.environ, share)
    world = server_options.find_world(options.world, folders)
    factor = real_time_factor(world, options.profile)
    _set_or_forget(name, {"real_time_factor": factor, "seed": options.seed})
    rospy.set_param(f"{tree}/world", world)
    rospy.set_param(f"{tree}/paused", options.pause)


def _set_or_forget(name, values):
    """Set parameters of the tree; those that are None are deleted if a gzserver before this one has set them.

    What was set is noted beside the tree, so that the user's own parameters stay.
    """
    for key, value in values.items():
        parameter, note = f"{name}/sim2d/{key}", f"{name}/gzserver/{key}"
        if value is not None:
            rospy.set_param(parameter, value)
            rospy.set_param(note, value)
        elif rospy.has_param(note):
            if rospy.get_param(parameter, None) == rospy.get_param(note):
                rospy.delete_param(parameter)
            rospy.delete_param(note)


def main(debugger=()):
    """Become the simulator.

    Args:
        debugger: command in front of the simulator's.
    """
    try:
        options, left_out = server_options.parse(sys.argv[1:])
        name = node_name(sys.argv)
        set_parameters(name, options)
        if left_out:
            print(f"gzserver: without effect here: {', '.join(left_out)}", file=sys.stderr)
        remappings = [each for each in sys.argv[1:] if ":=" in each]
        if not any(each.startswith("__name:=") for each in remappings):
            remappings.append(f"__name:={DEFAULT_NAME}")
        command = [*debugger, executable(), f"{name}/sim2d", *remappings]
        os.execvp(command[0], command)
    except UsageError as error:
        print(f"gzserver: {error}", file=sys.stderr)
        sys.exit(USAGE_EXIT_CODE)
    except OSError as error:
        print(f"gzserver: {error}", file=sys.stderr)
        sys.exit(1)
