"""spawn_model: takes a description from where it is told and asks the simulator to spawn it."""

import os
import sys
from xml.etree import ElementTree

import rospy
from gazebo_msgs.msg import ModelStates
from gazebo_msgs.srv import DeleteModel, SpawnModel
from geometry_msgs.msg import Point, Pose, Quaternion
from std_srvs.srv import Empty
from tf.transformations import quaternion_from_euler

from .errors import UsageError
from .spawn_options import parse


def read_description(options, environment):
    """Return the XML text.

    Raises:
        UsageError: it is not where the options say, or not XML.
    """
    text = _read(options, environment)
    try:
        ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        raise UsageError(f"the description is not XML: {error}") from None
    return text


def _read(options, environment):
    if options.param:
        if not rospy.has_param(options.param):
            raise UsageError(f"no parameter {rospy.resolve_name(options.param)}")
        return str(rospy.get_param(options.param))
    if options.stdin:
        return sys.stdin.read()
    path = options.file or database_file(options.database, environment)
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except OSError as error:
        raise UsageError(f"cannot read {path}: {error.strerror}") from None


def database_file(name, environment):
    """Path of the description of a model below GAZEBO_MODEL_PATH.

    Raises:
        UsageError: there is none.
    """
    folders = [folder for folder in environment.get("GAZEBO_MODEL_PATH", "").split(":") if folder]
    for folder in folders:
        path = os.path.join(folder, name, "model.sdf")
        if os.path.isfile(path):
            return path
    raise UsageError(
        f"no model {name}; looked in {', '.join(folders) or 'GAZEBO_MODEL_PATH, which is empty'}"
    )


def initial_pose(options):
    """Return the Pose of the options."""
    orientation = quaternion_from_euler(options.R, options.P, options.Y)
    return Pose(Point(options.x, options.y, options.z), Quaternion(*orientation))


def wait_for_model(name, namespace):
    """Block until the simulator has a model of this name."""
    rospy.loginfo("waiting for model %s", name)
    while not rospy.is_shutdown():
        if name in rospy.wait_for_message(f"{namespace}/model_states", ModelStates).name:
            return


def call(namespace, service, kind, *arguments):
    """Wait for a service of the simulator and call it."""
    name = f"{namespace}/{service}"
    rospy.wait_for_service(name)
    return rospy.ServiceProxy(name, kind)(*arguments)


def delete(options):
    """Delete the model, without waiting: the simulator may have ended first."""
    name = f"{options.gazebo_namespace}/delete_model"
    try:
        rospy.ServiceProxy(name, DeleteModel)(options.model)
    except rospy.ServiceException as error:
        rospy.logwarn("model %s was not deleted: %s", options.model, error)


def spawn(options, description):
    """Ask the simulator, bind the model to this node if wanted; return whether it worked."""
    answer = call(
        options.gazebo_namespace,
        f"spawn_{options.kind}_model",
        SpawnModel,
        options.model,
        description,
        options.robot_namespace,
        initial_pose(options),
        options.reference_frame,
    )
    if answer.success and options.bond:
        rospy.on_shutdown(lambda: delete(options))
    (rospy.loginfo if answer.success else rospy.logerr)("%s", answer.status_message)
    return answer.success


def main():
    """Spawn a model; return the exit code."""
    try:
        # Before the node, which waits for a master.
        options = parse(rospy.myargv()[1:], rospy.get_namespace())
        rospy.init_node("spawn_model", anonymous=True)
        description = read_description(options, os.environ)
        if options.joints:
            rospy.logwarn(
                "without effect here, joints start at 0: %s", ", ".join(name for name, _ in options.joints)
            )
        if options.wait:
            wait_for_model(options.wait, options.gazebo_namespace)
        if not spawn(options, description):
            return 1
        if options.unpause:
            call(options.gazebo_namespace, "unpause_physics", Empty)
        if options.bond:
            rospy.spin()
    except UsageError as error:
        print(f"spawn_model: {error}", file=sys.stderr)
        return 2
    except rospy.ROSInterruptException:
        return 1
    except rospy.ServiceException as error:
        print(f"spawn_model: {error}", file=sys.stderr)
        return 1
    return 0
