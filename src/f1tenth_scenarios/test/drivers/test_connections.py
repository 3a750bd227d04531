"""Which connections of a driver should be there and are not: nodes that say what they are connected with."""

import os
import threading
import time
import xmlrpc.client
import xmlrpc.server
from contextlib import ExitStack, contextmanager

import pytest
import rosgraph
from f1tenth_scenarios.drivers import connections
from f1tenth_scenarios.drivers.connections import Connections
from f1tenth_scenarios.launch.private_master import private_master

CALLER = "/robot1/proxy_driver"
CLOCK = "/robot1/proxy_driver/clock"


@contextmanager
def node(links, wait=0.0):
    """Serves a node that names its links: [id, other, direction, transport, topic, connected]."""

    def get_bus_info(_caller):
        time.sleep(wait)
        return 1, "", links

    with xmlrpc.server.SimpleXMLRPCServer(("localhost", 0), logRequests=False) as server:
        server.register_function(get_bus_info, "getBusInfo")
        threading.Thread(target=server.serve_forever, args=(0.01,), daemon=True).start()
        yield f"http://localhost:{server.server_address[1]}/"
        server.shutdown()


@pytest.fixture
def graph():
    """Registers nodes at a master: their links, what they publish, and what they subscribe to."""
    with ExitStack() as stack:
        uri = stack.enter_context(private_master())

        def add(name, links=(), publishes=(), subscribes=(), wait=0.0):
            own = stack.enter_context(node([[0, *each] for each in links], wait))
            master = xmlrpc.client.ServerProxy(uri)
            for topic in publishes:
                master.registerPublisher(name, topic, "*", own)
            for topic in subscribes:
                master.registerSubscriber(name, topic, "*", own)

        yield add


def outgoing(topic, subscriber):
    return [subscriber, "o", "TCPROS", topic, True]


def missing():
    return Connections(CALLER, CLOCK).missing()


def test_what_is_connected_is_not_missing(graph):
    graph(CALLER, [outgoing(CLOCK, "/robot1/planner")], publishes=[CLOCK])
    graph("/robot1/planner", subscribes=[CLOCK])
    assert missing() == set()


def test_who_subscribes_without_a_link_is_missing(graph):
    graph(CALLER, [["http://other", "i", "TCPROS", CLOCK, True]], publishes=[CLOCK])
    graph("/robot1/planner", subscribes=[CLOCK])
    assert missing() == {(CLOCK, CALLER, "/robot1/planner")}


def test_commands_are_what_the_driver_tells_the_simulator(graph):
    graph("/robot1/planner", publishes=["/robot1/drive", "/robot1/path"], subscribes=[CLOCK])
    graph("/robot2/planner", publishes=["/robot2/drive"])
    graph("/truck/servos", publishes=["/truck/steering/command"], subscribes=[CLOCK, "/robot1/path"])
    graph("/sim2d", subscribes=["/robot1/drive", "/robot2/drive", "/truck/steering/command"])
    one = Connections(CALLER, CLOCK)
    assert one.commands(one.registered(), "/sim2d") == {"/robot1/drive", "/truck/steering/command"}


def test_commands_have_to_reach_the_simulator(graph):
    graph(CALLER, [outgoing(CLOCK, "/robot1/planner")], publishes=[CLOCK])
    graph(
        "/robot1/planner",
        [outgoing("/robot1/drive", CALLER)],
        publishes=["/robot1/drive"],
        subscribes=[CLOCK],
    )
    graph("/sim2d", subscribes=["/robot1/drive"])
    assert missing() == {("/robot1/drive", "/robot1/planner", "/sim2d")}


def test_others_among_themselves_do_not_matter(graph):
    graph("/sim2d", publishes=["/clock"])
    graph("/rviz", subscribes=["/clock"])
    assert missing() == set()


def test_node_that_hears_itself_needs_no_link(graph):
    graph("/robot1/planner", publishes=["/robot1/path"], subscribes=[CLOCK, "/robot1/path"])
    assert missing() == set()


def test_publisher_that_is_gone_has_no_links(graph):
    master = xmlrpc.client.ServerProxy(rosgraph.get_master_uri())
    master.registerPublisher("/sim2d", "/robot1/odom", "*", "http://localhost:9/")
    graph("/robot1/planner", subscribes=[CLOCK, "/robot1/odom"])
    assert missing() == {("/robot1/odom", "/sim2d", "/robot1/planner")}


def test_publisher_that_does_not_answer_has_no_links(graph, monkeypatch):
    monkeypatch.setattr(connections, "_PATIENCE", 0.1)
    graph("/sim2d", [outgoing("/robot1/odom", "/robot1/planner")], publishes=["/robot1/odom"], wait=1.0)
    graph("/robot1/planner", subscribes=[CLOCK, "/robot1/odom"])
    assert missing() == {("/robot1/odom", "/sim2d", "/robot1/planner")}


def test_master_of_this_machine_is_a_process(graph):
    assert os.path.exists(f"/proc/{Connections(CALLER, CLOCK).master_process()}")


def test_master_of_another_machine_is_none(monkeypatch):
    monkeypatch.setenv("ROS_MASTER_URI", "http://192.0.2.1:11311")
    assert Connections(CALLER, CLOCK).master_process() is None


def test_registered_is_equal_until_something_changes(graph):
    one = Connections(CALLER, CLOCK)
    before = one.registered()
    assert one.registered() == before
    graph("/robot1/planner", subscribes=[CLOCK])
    assert one.registered() != before
