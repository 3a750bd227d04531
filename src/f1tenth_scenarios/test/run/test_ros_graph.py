"""Who is stopped does not hold up who asks."""

import socket
import time

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_scenarios.run.ros_graph import RosGraph, ask, publications_of, read_graph


@pytest.fixture
def deaf_master(monkeypatch):
    """A master that takes connections and never answers."""
    with socket.create_server(("localhost", 0)) as server:
        monkeypatch.setenv("ROS_MASTER_URI", f"http://localhost:{server.getsockname()[1]}")
        yield


def test_master_that_does_not_answer_knows_nobody(deaf_master):
    begun = time.monotonic()
    assert read_graph(patience=0.2) == RosGraph()
    assert list(publications_of(["robot1/planner"])) == []
    assert time.monotonic() - begun < 30.0


def test_node_that_cannot_be_asked_is_named(deaf_master):
    with pytest.raises(ScenarioError, match="^cannot find robot1/planner: timed out$"):
        ask("robot1/planner", "getPid", patience=0.2)


def test_master_that_is_not_there_knows_nobody(monkeypatch):
    with socket.create_server(("localhost", 0)) as server:
        port = server.getsockname()[1]
    monkeypatch.setenv("ROS_MASTER_URI", f"http://localhost:{port}")
    assert read_graph() == RosGraph()


def test_who_publishes_nothing_but_its_log_does_not_speak():
    graph = RosGraph({"/rosout": ["a", "b"], "/scan": ["b"]})
    assert not graph.speaks("a")
    assert graph.speaks("b")
    assert graph.nodes == ["a", "b"]
