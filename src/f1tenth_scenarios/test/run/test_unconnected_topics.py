"""A driver that cannot work is told so by the topics that lead nowhere, or to another car's driver."""

import pytest
from f1tenth_judge.plan.participants import driver_nodes_among
from f1tenth_judge.scenario.driver import Interface
from f1tenth_scenarios.run.diagnosis.unconnected_topics import (
    CarTopics,
    driver_nodes,
    meddling,
    shared_topic,
    why_mute,
)
from f1tenth_scenarios.run.ros_graph import RosGraph

STAMPED, TWIST = "ackermann_msgs/AckermannDriveStamped", "geometry_msgs/Twist"
TAKES = f"the car takes {STAMPED} on /robot1/drive or {TWIST} on /robot1/cmd_vel"


def why(published=(), heard=(), offered=(), read=(), interface=Interface.NATIVE, **more):
    """What is said of robot1/planner, which publishes and hears topics; others offer and read some."""
    subscribers = {topic: ["robot1/planner"] for topic in heard} | {topic: ["sim2d"] for topic in read}
    publishers = {topic: ["sim2d"] for topic in offered} | {"/gazebo/model_states": ["sim2d"]}
    return why_mute(RosGraph(publishers, subscribers), "robot1", published, interface, **more)


def test_driver_that_is_connected_is_told_nothing():
    assert why([("/robot1/drive", STAMPED)], ["/robot1/scan"], ["/robot1/scan"], ["/robot1/drive"]) == []


@pytest.mark.parametrize(
    "kind", [STAMPED, TWIST, "ackermann_msgs/AckermannDrive", "geometry_msgs/TwistStamped"]
)
def test_commands_that_nobody_hears_are_named(kind):
    assert why([("/nav", kind)])[:2] == [f"publishes {kind} on /nav, which nobody hears", TAKES]


def test_a_driver_without_a_publisher_is_told_what_the_car_takes():
    wanted = f"publishes no command, which the car takes as {TAKES.removeprefix('the car takes ')}"
    assert why(heard=["/robot1/scan"], offered=["/robot1/scan"]) == [wanted]


def test_a_driver_without_a_subscriber_is_told_that_nothing_calls_it():
    found = why(
        [("/robot1/drive", STAMPED)],
        heard=["/robot1/proxy_driver/clock"],
        offered=["/robot1/proxy_driver/clock"],
    )
    assert found == ["hears no topic, so that no callback runs"]


def test_a_topic_of_another_type_is_told_with_both():
    misread = [("/robot1/proxy_driver/scan", "sensor_msgs/PointCloud2", "sensor_msgs/LaserScan")]
    heard = ["/robot1/proxy_driver/scan"]
    assert why([("/robot1/drive", STAMPED)], heard, heard, misread=misread) == [
        "hears /robot1/scan as sensor_msgs/PointCloud2, but it is sensor_msgs/LaserScan"
    ]


def test_topics_that_mean_one_of_the_car_are_told_how_to_get_there():
    (*_, hint) = why([("/cmd_vel", TWIST), ("/nav", STAMPED)], heard=["/scan", "/car/odom", "/key"])
    assert hint == (
        'in front of its nodes in the launch file, <remap from="/cmd_vel" to="cmd_vel"/><remap from="/nav"'
        ' to="drive"/><remap from="/car/odom" to="perfect_odom"/><remap from="/scan" to="scan"/> leads to the'
        " car's topics (odom drifts, perfect_odom is exact)"
    )
    assert why([("/nav", "ackermann_msgs/AckermannDrive")])[-1] == TAKES


def test_topics_of_a_car_of_one_s_own_are_named():
    topics = CarTopics({"drive": STAMPED, "/truck/cmd_vel": TWIST}, {"scan": "/front_laser/scan"})
    assert why([("/cmd_vel", TWIST)], heard=["/scan"], topics=topics)[2:] == [
        f"the car takes {STAMPED} on /robot1/drive or {TWIST} on /truck/cmd_vel",
        'in front of its nodes in the launch file, <remap from="/cmd_vel" to="/truck/cmd_vel"/>'
        '<remap from="/scan" to="/front_laser/scan"/> leads to the car\'s topics',
    ]


def test_car_that_only_controllers_drive_is_told_of():
    assert why(topics=CarTopics({}, {})) == [
        "the car is driven by controllers, which the planner's launch file is to load and to feed"
    ]


def test_commands_that_a_node_passes_on_and_what_are_no_commands_are_not():
    assert why([("/nav", STAMPED), ("/markers", "visualization_msgs/Marker")], read=["/nav"]) == []


@pytest.mark.parametrize(("topic", "kind"), [("/robot1/drive", TWIST), ("/robot1/cmd_vel", STAMPED)])
def test_commands_of_another_type_than_the_car_takes_are_named(topic, kind):
    assert why([(topic, kind)], read=[topic]) == [f"publishes {kind} on {topic}", TAKES]


def test_who_only_listens_passes_no_command_on():
    graph = RosGraph({"/rosout": ["robot1/record"]}, {"/nav": ["robot1/record"]})
    assert why_mute(graph, "robot1", [("/nav", TWIST)], Interface.NATIVE)


def test_inputs_that_a_person_gives_in_rviz_are_not_missed():
    heard = ["/robot1/initialpose", "/move_base_simple/goal", "/tf_static"]
    assert why([("/robot1/drive", STAMPED)], heard) == []


def test_inputs_that_nobody_publishes_are_named():
    assert why([("/robot1/drive", STAMPED)], ["/joy", "/key"]) == [
        "hears /joy and /key, which nobody publishes"
    ]


def test_who_hears_transforms_is_told_of_their_frames():
    assert why([("/robot1/drive", STAMPED)], ["/tf", "/tf_static"], ["/tf"]) == [
        "frames of the car in /tf begin with robot1/"
    ]


def test_who_typed_make_is_told_what_make_takes(monkeypatch):
    monkeypatch.setenv("F1TENTH_TYPED", "make")
    assert "use INTERFACE=f1tenth" in why(heard=["/scan"])


@pytest.mark.parametrize(("interface", "is_told"), [(Interface.NATIVE, True), (Interface.F1TENTH, False)])
def test_names_of_f1tenth_simulator_are_known(interface, is_told):
    assert ("use --interface f1tenth" in why(heard=["/scan"], interface=interface)) == is_told
    assert ("use --interface f1tenth" in why([("/drive", STAMPED)], interface=interface)) == is_told


def test_driver_s_nodes_are_those_that_send_commands_first():
    graph = RosGraph(
        {"/robot1/drive": ["robot1/z"], "/robot2/drive": ["robot2/b"]},
        {"/robot1/scan": ["robot1/a", "robot1/collision_detection"]},
        {"/robot1/y/get_loggers": ["robot1/y"]},
    )
    assert driver_nodes(graph, "robot1") == ["robot1/z", "robot1/a", "robot1/y"]


def test_nodes_that_take_part_in_lockstep_for_others_are_no_drivers():
    nodes = [
        "robot1/proxy_driver_roscpp",
        "robot1/proxy_driver",
        "robot1/wall_follow",
    ]
    assert driver_nodes_among("robot1", nodes) == ["robot1/wall_follow"]


def shared(publishers, hearers, topic="/nav"):
    speaking = {f"/{car}/drive": [f"{car}/mux", f"{car}/planner"] for car in ("robot1", "robot2")}
    return shared_topic(RosGraph({**speaking, topic: publishers}, {topic: hearers}), ["robot1", "robot2"])


def test_driver_that_hears_that_of_another_car_is_found():
    node, text = shared(["robot1/planner", "robot2/planner"], ["robot2/mux", "robot1/mux"])
    assert node == "robot1/mux"
    assert text == (
        "hears /nav of robot2/planner, which drives another car: the drivers of robot1 and robot2 share this"
        " topic; name it without the leading slash"
    )


@pytest.mark.parametrize(
    ("publishers", "hearers", "topic"),
    [
        (["robot1/planner"], ["robot1/mux"], "/nav"),
        (["robot1/planner"], ["robot2/mux"], "/plans"),  # meant for the other
        (["robot1/planner", "robot2/planner"], ["rviz", "robot1/rviz", "robot2/record"], "/markers"),
        (["robot1/map_server", "robot2/map_server"], ["robot1/planner"], "/map"),
        (["robot1/planner", "robot2/planner"], ["robot1/planner"], "/tf"),
        (["robot1/move_base", "robot2/move_base"], ["robot1/move_base"], "/sim2d/done"),
        (["robot1/planner", "robot2/planner"], ["robot1/planner"], "/robot1/plan"),
    ],
)
def test_what_drivers_may_share_is_not(publishers, hearers, topic):
    assert shared(publishers, hearers, topic) is None


def meddler(topic, publisher, car_of=lambda _node: None):
    publishers = {
        "/robot1/drive": ["robot1/planner"],
        "/robot2/scan": ["sim2d"],
        "/robot2/plan": ["robot2/planner"],
    }
    publishers[topic] = [*publishers.get(topic, ()), publisher]
    heard = {f"/{car}/{name}": ["sim2d"] for car in ("robot1", "robot2") for name in ("drive", "cmd_vel")}
    return meddling(RosGraph(publishers, heard), ["robot1", "robot2"], car_of)


@pytest.mark.parametrize("name", ["drive", "cmd_vel", "scan", "initialpose"])
def test_driver_that_drives_or_blinds_another_car_is_found(name):
    topic = f"/robot2/{name}"
    assert meddler(topic, "robot1/planner") == (
        "robot1/planner",
        f"publishes {topic}, and drives another car",
    )


def test_whose_driver_a_node_outside_all_cars_is_tells_its_process():
    found = [meddler("/robot2/drive", "helper", {"helper": car}.get) for car in ("robot1", "robot2", None)]
    assert found == [("helper", "publishes /robot2/drive, and drives another car"), None, None]


@pytest.mark.parametrize(
    ("topic", "publisher"),
    [
        ("/robot2/drive", "robot2/planner"),
        ("/robot2/scan", "robot2/faulty_inputs"),
        ("/robot2/plan", "robot1/planner"),  # between planners
        ("/robot1/cmd_vel", "robot1/proxy_driver"),
        ("/tf", "robot1/planner"),
    ],
)
def test_what_is_a_driver_s_own_is_not(topic, publisher):
    assert meddler(topic, publisher) is None
