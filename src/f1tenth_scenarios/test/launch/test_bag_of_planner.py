"""What planners draw and publish as numbers, read from a bag."""

import base64
import io
import math

import PIL.Image
import pytest
import rospy
from f1tenth_judge.record.replay import Drawing, Timed
from f1tenth_judge.said import said as limits
from f1tenth_scenarios.launch.bag_reader import read_bag
from geometry_msgs.msg import Point, Pose, PoseArray, PoseStamped, TransformStamped
from nav_msgs.msg import Path
from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import Float32, Float64
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

GREEN = "#00ff00"


def drawing(colour=GREEN, **parts):
    return Drawing(colour, **{"lines": [], "dots": [], "texts": [], **parts})


def marker(kind, *points, number=0, frame="map", stamp=0.0, **others):
    made = Marker(type=kind, id=number, **others)
    made.header.frame_id, made.header.stamp = frame, rospy.Time.from_sec(stamp)
    made.pose.orientation.w = 1.0
    made.scale.x, made.scale.y = 0.4, 0.2
    made.color.g = made.color.a = 1.0
    made.points = [Point(x, y, 0.0) for x, y in points]
    return made


def at(x, y, yaw=0.0):
    pose = Pose()
    pose.position.x, pose.position.y = x, y
    pose.orientation.z, pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
    return pose


def drawn(bag, *messages, topic="/robot1/drawn"):
    """What the replay shows of messages (when, message), with the stamps."""
    replay, too_much = read_bag(bag(*((topic, heard, message) for heard, message in messages)), ["robot1"])
    assert too_much == []
    found = replay.drawings.get(topic)
    return list(zip(found.stamps, found.values)) if found else []


@pytest.mark.parametrize(
    ("said", "shown"),
    [
        (marker(Marker.LINE_STRIP, (0, 0), (1, 2)), {"lines": [[(0, 0), (1, 2)]]}),
        (
            marker(Marker.LINE_LIST, (0, 0), (1, 2), (3, 4), (5, 6)),
            {"lines": [[(0, 0), (1, 2)], [(3, 4), (5, 6)]]},
        ),
        (marker(Marker.SPHERE), {"dots": [(0, 0, 0.2)]}),
        (marker(Marker.POINTS, (1, 2)), {"dots": [(1, 2, 0.2)]}),
        (
            marker(Marker.CUBE),
            {"lines": [[(-0.2, -0.1), (0.2, -0.1), (0.2, 0.1), (-0.2, 0.1), (-0.2, -0.1)]]},
        ),
        (
            marker(Marker.TRIANGLE_LIST, (0, 0), (1, 0), (0, 1)),
            {"lines": [[(0, 0), (1, 0), (0, 1), (0, 0)]]},
        ),
        (marker(Marker.TEXT_VIEW_FACING, text="brake"), {"texts": [(0, 0, "brake")]}),
        (
            marker(Marker.ARROW, (0, 0), (2, 0)),
            {"lines": [[(0, 0), (2, 0), (1.4, 0.3), (1.4, -0.3), (2, 0)]]},
        ),
    ],
)
def test_markers_of_every_kind_lie_flat(bag, said, shown):
    assert drawn(bag, (1.0, said)) == [(1.0, [drawing(**shown)])]


def test_markers_stay_until_they_are_replaced_deleted_or_too_old(bag):
    first = marker(Marker.SPHERE, number=1)
    first.pose = at(1, 0)
    brief = marker(Marker.SPHERE, number=2, lifetime=rospy.Duration(0.3))
    moved = marker(Marker.SPHERE, number=1)
    moved.pose = at(2, 0)
    gone = marker(Marker.SPHERE, number=1, action=Marker.DELETE)
    shown = drawn(bag, (1.0, first), (1.01, brief), (1.5, moved), (2.0, gone))
    assert [[each.dots[0][0] for each in values] for _, values in shown] == [[1, 0], [2], []]


def test_markers_in_the_frame_of_a_car_are_drawn_where_it_was(bag):
    def transform(stamp, x):
        each = TransformStamped()
        each.header.frame_id, each.child_frame_id = "map", "robot1/base_link"
        each.header.stamp = rospy.Time.from_sec(stamp)
        each.transform.translation.x = x
        each.transform.rotation = at(0, 0, math.pi / 2).orientation
        return "/tf", stamp, TFMessage([each])

    said = marker(Marker.POINTS, (1, 0), frame="robot1/base_link", stamp=1.5)
    lost = marker(Marker.POINTS, (1, 0), frame="nowhere", number=1)
    file = bag(transform(1.0, 1.0), transform(2.0, 2.0), ("/robot1/a", 1.5, said), ("/robot1/b", 1.5, lost))
    assert read_bag(file, ["robot1"])[0].drawings == {
        "/robot1/a": Timed([1.5], [[drawing(dots=[(1.5, 1.0, 0.2)])]])
    }


def test_paths_and_poses_are_drawn_without_a_colour(bag):
    path = Path(poses=[PoseStamped(pose=at(x, 0)) for x in range(3)])
    assert drawn(bag, (1.0, path)) == [(1.0, [drawing("", lines=[[(0, 0), (1, 0), (2, 0)]])])]
    ((_, (arrows,)),) = drawn(bag, (1.0, PoseArray(poses=[at(1, 1, math.pi / 2)])))
    assert arrows.lines[0][:2] == [(1, 1), (1, 1.25)]


@pytest.mark.parametrize("topic", ["move_base/goals_ahead", "race_goals"])
def test_goals_that_the_replay_shows_anyway_are_not_drawn(bag, topic):
    goals = PoseArray(poses=[at(1, 1)])
    assert drawn(bag, (1.0, goals), topic=f"/robot1/{topic}") == []
    assert drawn(bag, (1.0, goals), topic="/robot1/own_goals") != []


def test_what_cannot_be_seen_is_not_drawn(bag):
    clear = marker(Marker.SPHERE)
    clear.color.a = 0.0
    nowhere = marker(Marker.LINE_STRIP, (math.nan, 0), number=1)
    unknown = marker(99, number=2)
    assert drawn(bag, (1.0, MarkerArray([clear, nowhere, unknown]))) == []


def test_what_is_too_much_is_named(bag, monkeypatch):
    monkeypatch.setattr(limits, "_MOST_POINTS", 5)
    monkeypatch.setattr(limits, "_MOST_TOPICS", 1)
    line = marker(Marker.LINE_STRIP, (0, 0), (1, 0), (2, 0))
    file = bag(*(("/robot1/a", stamp, line) for stamp in (1, 2, 3, 4)), ("/robot1/b", 1, line))
    replay, too_much = read_bag(file, ["robot1"])
    assert replay.drawings["/robot1/a"].stamps == [1, 2]
    assert too_much == [
        "/robot1/a: left out from 3.000 s on, as it has more than 5 points",
        "/robot1/b: left out, as there are more than 1 of its kind",
    ]


def test_numbers_are_those_of_the_car_whose_node_publishes_them(bag):
    file = bag(
        ("/error", 1.0, Float64(0.25)),
        ("/error", 1.01, Float64(9.0)),
        ("/error", 1.05, Float64(math.nan)),
        ("/error", 1.1, Float64(-0.5)),
        ("/robot1/gain", 2.0, Float32(2.0)),
    )
    found = read_bag(file, ["robot1"])[0].channels
    assert {topic: (each.car, each.stamps, each.values) for topic, each in found.items()} == {
        "/error": ("robot1", [1.0, 1.1], [0.25, -0.5]),
        "/robot1/gain": ("robot1", [2.0], [2.0]),
    }


def test_what_nodes_of_no_car_publish_is_not_the_planners(bag):
    messages = [("/a", 1.0, Float64(1.0)), ("/b", 1.0, marker(Marker.SPHERE))]
    replay, _ = read_bag(bag(*messages, node="/sim2d"), ["robot1"])
    assert (replay.channels, replay.drawings) == ({}, {})


def seen(encoding="rgb8", pixel=(200, 30, 40), width=320, height=240):
    return Image(
        height=height,
        width=width,
        encoding=encoding,
        data=bytes(pixel) * width * height,
        step=len(pixel) * width,
    )


def colour_of(packed):
    picture = PIL.Image.open(io.BytesIO(base64.b64decode(packed)))
    assert picture.size == (160, 120)
    return picture.getpixel((80, 60))


def test_what_a_camera_showed_is_kept_small_twice_a_second(bag):
    topic = "/robot1/camera/image_raw"
    red, blue = seen(), seen("bgr8", (200, 30, 40))
    file = bag((topic, 1.0, red), (topic, 1.2, red), (topic, 1.5, blue), node="/sim2d")
    pictures = read_bag(file, ["robot1"])[0].pictures
    assert pictures[topic].stamps == [1.0, 1.5]
    assert [colour_of(each) for each in pictures[topic].values] == [
        pytest.approx((200, 30, 40), abs=6),
        pytest.approx((40, 30, 200), abs=6),
    ]


def test_depth_and_broken_pictures_are_not_shown(bag):
    depth = seen("32FC1", (0, 0, 0, 0))
    broken = seen()
    broken.data = broken.data[:100]
    torn = CompressedImage(format="jpeg", data=b"torn")
    file = bag(("/robot1/depth", 1.0, depth), ("/robot1/broken", 1.0, broken), ("/robot1/torn", 1.0, torn))
    assert read_bag(file, ["robot1"])[0].pictures == {}
