"""Goals keep their numbers, and each place of contact is marked once."""

from diagnostic_msgs.msg import DiagnosticStatus, KeyValue
from f1tenth_navigation.contact_markers import MOST, ContactPlaces
from f1tenth_navigation.goal_markers import goal_markers, trouble_marker
from f1tenth_navigation.known_goals import KnownGoals
from gazebo_msgs.msg import ContactsState, ContactState
from geometry_msgs.msg import Pose, PoseArray, PoseStamped, Quaternion, Vector3
from visualization_msgs.msg import Marker


def stamped(x, y, z=0.0):
    message = PoseStamped()
    message.header.frame_id = "map"
    message.pose.position.x, message.pose.position.y = x, y
    message.pose.orientation = Quaternion(z=z, w=(1.0 - z * z) ** 0.5)
    return message


def race(*poses):
    message = PoseArray(poses=[each.pose for each in poses])
    message.header.frame_id = "map"
    return message


def contacts(x, other="Wall_1::link::collision"):
    state = ContactState(collision1_name="robot1::base_link::bumper", collision2_name=other)
    state.contact_positions = [Vector3(x, 0.5, 0.1)]
    return ContactsState(states=[state])


def shown(goals):
    markers = goal_markers(goals.poses).markers
    return [(each.text, each.pose.position.x) for each in markers if each.ns == "numbers"]


def test_goal_that_is_sent_once_more_keeps_its_number():
    goals = KnownGoals()
    assert goals.take_sent(stamped(1.0, 0.0))
    assert goals.take_sent(stamped(2.0, 0.0))
    assert not goals.take_sent(stamped(1.0, 0.0))
    assert shown(goals) == [("1", 1.0), ("2", 2.0)]


def test_goal_of_another_heading_is_another_goal():
    goals = KnownGoals()
    assert goals.take_sent(stamped(1.0, 0.0))
    assert goals.take_sent(stamped(1.0, 0.0, z=0.5))


def test_goals_of_a_race_replace_those_before_and_are_known():
    goals = KnownGoals()
    goals.take_sent(stamped(9.0, 0.0))
    goals.take_race(race(stamped(1.0, 0.0), stamped(2.0, 0.0)))
    assert not goals.take_sent(stamped(2.0, 0.0))
    assert shown(goals) == [("1", 1.0), ("2", 2.0)]


def problems(goals):
    markers = goal_markers(goals.poses, goals.problems).markers
    return [(each.text, each.pose.position.x) for each in markers if each.ns == "problems"]


def test_goal_that_the_planner_gives_up_is_marked_with_the_reason():
    goals = KnownGoals()
    goals.take_sent(stamped(1.0, 0.0), "a")
    goals.take_sent(stamped(2.0, 0.0), "b")
    assert goals.take_failure("b", "in a wall")
    assert not goals.take_failure("c", "of somebody else's")
    assert problems(goals) == [("in a wall", 2.0)]
    discs = [each.color for each in goal_markers(goals.poses, goals.problems).markers if each.ns == "discs"]
    assert discs[0].b > discs[0].r
    assert discs[1].r > discs[1].b


def test_a_car_that_stands_still_says_why():
    status = DiagnosticStatus(
        level=DiagnosticStatus.WARN, message="No way.", values=[KeyValue("frame", "robot1/base_footprint")]
    )
    marker = trouble_marker(status)
    assert marker.text == "No way."
    assert marker.header.frame_id == "robot1/base_footprint"
    assert marker.frame_locked
    status.level = DiagnosticStatus.OK
    assert trouble_marker(status) is None


def test_goal_that_is_tried_once_more_is_no_problem_until_it_is_one():
    goals = KnownGoals()
    goals.take_sent(stamped(1.0, 0.0), "a")
    goals.take_failure("a", "in a wall")
    assert goals.take_sent(stamped(1.0, 0.0), "b")
    assert problems(goals) == []
    goals.take_failure("b", "no way")
    assert problems(goals) == [("no way", 1.0)]


def test_race_begins_without_problems():
    goals = KnownGoals()
    goals.take_sent(stamped(1.0, 0.0), "a")
    goals.take_failure("a", "in a wall")
    goals.take_race(race(stamped(1.0, 0.0)))
    assert problems(goals) == []


def test_number_stands_out_from_what_is_below():
    markers = goal_markers([stamped(1.0, 0.0)]).markers
    number, disc, arrow = (
        next(each for each in markers if each.ns == name) for name in ("numbers", "discs", "arrows")
    )
    assert number.pose.position.z > disc.pose.position.z > arrow.pose.position.z
    assert (
        min(number.color.r, number.color.g, number.color.b) - max(disc.color.r, disc.color.g, disc.color.b)
        > 0.5
    )
    assert disc.scale.x > number.scale.z


def test_markers_replace_those_before():
    assert goal_markers([]).markers[0].action == Marker.DELETEALL
    assert ContactPlaces().markers("map").markers[0].action == Marker.DELETEALL


def test_each_place_of_contact_is_marked_once():
    places = ContactPlaces()
    assert places.take(contacts(1.0))
    assert not places.take(contacts(1.05))
    assert places.take(contacts(1.2))
    balls = places.markers("map").markers[1:]
    assert [ball.pose.position.x for ball in balls] == [1.0, 1.2]
    assert len({ball.id for ball in balls}) == 2
    assert {ball.header.frame_id for ball in balls} == {"map"}


def test_ground_is_no_contact():
    assert not ContactPlaces().take(contacts(1.0, other="ground_plane::link::collision"))


def test_number_of_places_is_limited():
    places = ContactPlaces()
    for index in range(MOST + 5):
        places.take(contacts(float(index)))
    balls = places.markers("map").markers[1:]
    assert (len(balls), balls[0].pose.position.x) == (MOST, 5.0)


def test_pose_of_a_goal_is_taken_over():
    goals = KnownGoals()
    goals.take_race(race(stamped(1.0, 2.0, z=0.5)))
    (arrow,) = (each for each in goal_markers(goals.poses).markers if each.ns == "arrows")
    assert arrow.pose == Pose(arrow.pose.position, stamped(1.0, 2.0, z=0.5).pose.orientation)
    assert (arrow.pose.position.y, arrow.header.frame_id) == (2.0, "map")
