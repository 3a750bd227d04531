"""Pushing a model of the simulator."""

import math

import rospy
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.scenario.scenario import Push
from gazebo_msgs.srv import GetModelState, SetModelState

_PATIENCE = 5.0  # wall s


def push_model(name: str, push: Push) -> None:
    """Give a model a velocity, where it is.

    Raises:
        ScenarioError: the simulator does not know it, or does not answer.
    """
    try:
        found = _call("get_model_state", GetModelState)(model_name=name)
        if not found.success:
            raise ScenarioError(f"cannot push {name}: {found.status_message}")
        request = SetModelState._request_class()
        request.model_state.model_name = name
        request.model_state.pose = found.pose
        request.model_state.twist.linear.x = push.speed * math.cos(push.direction)
        request.model_state.twist.linear.y = push.speed * math.sin(push.direction)
        answer = _call("set_model_state", SetModelState)(request)
    except (rospy.ServiceException, rospy.ROSException) as error:
        raise ScenarioError(f"cannot push {name}: {error}") from error
    if not answer.success:
        raise ScenarioError(f"cannot push {name}: {answer.status_message}")


def _call(service, kind):
    rospy.wait_for_service(f"/gazebo/{service}", _PATIENCE)
    return rospy.ServiceProxy(f"/gazebo/{service}", kind)
