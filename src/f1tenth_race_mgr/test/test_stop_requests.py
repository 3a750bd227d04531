"""Who ends the race, and who the node."""

import signal

import pytest
from f1tenth_race_mgr.stop_requests import StopRequests
from std_srvs.srv import Trigger, TriggerRequest

from f1tenth_race_mgr import stop_requests


@pytest.fixture
def ros(monkeypatch):
    """Stands in for rospy and signal; gives what was asked of them."""
    asked = {"handlers": {}, "services": [], "down": False}
    monkeypatch.setattr(stop_requests.rospy, "Service", lambda *service: asked["services"].append(service))
    monkeypatch.setattr(stop_requests.rospy, "is_shutdown", lambda: asked["down"])
    monkeypatch.setattr(
        stop_requests.signal, "signal", lambda number, handler: asked["handlers"].update({number: handler})
    )
    return asked


def test_nothing_is_asked_for_at_first(ros):
    requests = StopRequests()
    assert (requests.race, requests.node) == (False, False)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signal_stops_race_and_node(ros, number):
    requests = StopRequests()
    ros["handlers"][number](number, None)
    assert (requests.race, requests.node) == (True, True)


def test_end_of_ros_stops_race_and_node(ros):
    requests = StopRequests()
    ros["down"] = True
    assert (requests.race, requests.node) == (True, True)


def test_service_stops_the_race_only(ros):
    requests = StopRequests()
    ((name, kind, serve),) = ros["services"]
    assert (name, kind) == ("~stop", Trigger)
    answer = serve(TriggerRequest())
    assert (answer.success, answer.message) == (True, "the race is being stopped")
    assert (requests.race, requests.node) == (True, False)
