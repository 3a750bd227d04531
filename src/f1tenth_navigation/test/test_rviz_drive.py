"""A user's first minute: simulator, rviz, a click on the map, and the car drives there."""

import contextlib
import math
import os

import pytest
import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, Twist, Vector3
from move_base_msgs.msg import MoveBaseActionResult
from nav_msgs.msg import Odometry
from PIL import Image
from ros_session import Latest, free_port, launched, missing_nodes, wait_until
from screen import Screen, missing_programs

NODES = [("f1tenth_sim2d", "sim2d"), ("map_server", "map_server"), ("move_base", "move_base")]
MISSING = ", ".join([*missing_programs(), *missing_nodes(NODES)])

# Where one_car.rviz shows the map.
VIEW_CENTRE = (1.0, 2.5)  # m
VIEW_CENTRE_PIXEL = (874, 466)
PIXELS_PER_METRE = 55

# How one_car.rviz shows what there is.
COLOURS = {
    "map": (199, 201, 202),
    "car model": (18, 59, 140),
    "scan": (255, 60, 60),
    "global plan": (0, 200, 80),
    "local plan": (255, 170, 0),
    "global costmap": (194, 214, 215),
    "local costmap": (116, 230, 231),
    "numbered goal": (214, 25, 151),
    "contact": (250, 225, 0),
}
TOPICS = {
    "/map",
    "/robot1/scan",
    "/robot1/perfect_odom",
    "/robot1/move_base/global_plan",
    "/robot1/move_base/local_plan",
    "/robot1/move_base/global_costmap/costmap",
    "/robot1/move_base/local_costmap/costmap",
    "/robot1/goal_markers",
    "/robot1/contact_markers",
}
GOAL = (7.5, 2.5)  # m, a quarter of a lap from the start, where the driving direction is +y
HALFWAY = 4.0  # m from the goal


def pixel(x, y):
    return (
        round(VIEW_CENTRE_PIXEL[0] + (x - VIEW_CENTRE[0]) * PIXELS_PER_METRE),
        round(VIEW_CENTRE_PIXEL[1] - (y - VIEW_CENTRE[1]) * PIXELS_PER_METRE),
    )


def near(wanted, colour):
    """Whether colours differ by no more than light and blending explain."""
    return all(abs(a - b) <= 10 for a, b in zip(wanted, colour))


class User:
    """Looks at the screen, and uses mouse and keyboard."""

    def __init__(self, screen, folder):
        self.screen = screen
        self.picture = os.path.join(folder, "rviz.png")
        self.odometry = Latest("/robot1/perfect_odom", Odometry)
        self.goal = Latest("/robot1/move_base_simple/goal", PoseStamped)
        self.result = Latest("/robot1/move_base/result", MoveBaseActionResult)
        self.closest_to_goal = math.inf  # m
        self.seen = set()
        self.velocity = rospy.Publisher("/robot1/cmd_vel", Twist, queue_size=1)
        rospy.Subscriber("/robot1/perfect_odom", Odometry, self.on_odometry)

    def on_odometry(self, message):
        position = message.pose.pose.position
        self.closest_to_goal = min(self.closest_to_goal, math.dist((position.x, position.y), GOAL))

    def wait_for_rviz(self):
        self.odometry.get()
        wait_until(lambda: self.screen.takes_keyboard("RViz"), "rviz takes the keyboard")
        wait_until(lambda: self.rviz_subscriptions() >= TOPICS, "rviz listens to everything")
        wait_until(lambda: self.sees("map", "car model", "scan"), "map, car and scan are in the picture")

    def rviz_subscriptions(self):
        _, subscribers, _ = rosgraph.Master(rospy.get_name()).getSystemState()
        return {topic for topic, nodes in subscribers if "/rviz" in nodes}

    def has_driven_into_the_wall(self):
        """Keep on steering to the right until a contact is seen."""
        self.velocity.publish(Twist(linear=Vector3(x=1.5), angular=Vector3(z=-1.0)))
        return self.sees("contact")

    def sees(self, *things):
        """Whether all of them are in the picture."""
        self.seen = set()
        return self.has_seen(*things)

    def has_seen(self, *things):
        """Whether each of them is in the picture, or was in one before."""
        self.screen.save_picture(self.picture)
        with Image.open(self.picture) as image:
            colours = [colour for _, colour in image.convert("RGB").getcolors(1 << 24)]
        self.seen |= {thing for thing in things if any(near(COLOURS[thing], colour) for colour in colours)}
        return self.seen >= set(things)


@pytest.fixture
def user(tmp_path, monkeypatch):
    monkeypatch.setenv("ROS_MASTER_URI", f"http://localhost:{free_port()}")
    with contextlib.ExitStack() as resources:
        screen = resources.enter_context(contextlib.closing(Screen()))
        # Slowly: rviz without a graphics card draws now and then, and is to do so while the car drives.
        simulated = ("world_file_name:=circuit1", "real_time_factor:=0.2")
        resources.enter_context(launched("f1tenth_gazebo", "sim_one_car.launch", *simulated))
        wait_until(rosgraph.is_master_online, "there is a master")
        rospy.init_node("rviz_drive_test", disable_signals=True)
        resources.callback(rospy.signal_shutdown, "the test has ended")
        # Now and then rviz crashes at its start on the software renderer, before it has a window.
        shown = ("rviz.launch", "respawn:=true")
        resources.enter_context(launched("f1tenth_navigation", *shown, environment=screen.environment))
        yield User(screen, os.environ.get("F1TENTH_PICTURES", tmp_path))


@pytest.mark.skipif(bool(MISSING), reason=f"not there: {MISSING}")
def test_car_drives_to_the_place_that_is_clicked_on(user):
    user.wait_for_rviz()
    user.screen.press_key("g")
    user.screen.drag(pixel(*GOAL), pixel(GOAL[0], GOAL[1] + 1.0))

    goal = user.goal.get().pose
    assert math.dist((goal.position.x, goal.position.y), GOAL) < 0.2
    assert math.isclose(goal.orientation.z, math.sqrt(0.5), abs_tol=0.05)

    wait_until(lambda: user.closest_to_goal < HALFWAY, "the car is on its way")
    shown = COLOURS.keys() - {"contact"}
    wait_until(lambda: user.has_seen(*shown), "plans, costmaps and goal were in the picture")
    assert user.result.get().status.status == GoalStatus.SUCCEEDED
    wait_until(lambda: user.closest_to_goal < 0.4, "the car was at its goal")

    wait_until(user.has_driven_into_the_wall, "the contact is in the picture")
