#!/usr/bin/env python3
"""Drives straight on, and after some seconds does something that no driver may."""

import contextlib
import os
import random
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from xmlrpc.client import ServerProxy

import genpy
import rosgraph
import roslib.message
import rosnode
import rospy
import rosservice
from ackermann_msgs.msg import AckermannDriveStamped
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from gazebo_msgs.msg import ContactsState, ModelState, ModelStates
from gazebo_msgs.srv import (
    DeleteModel,
    GetPhysicsProperties,
    GetWorldProperties,
    SetModelState,
    SetPhysicsProperties,
    SpawnModel,
)
from geometry_msgs.msg import Point, Pose, PoseWithCovarianceStamped, Quaternion
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock, Log
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool, Header, Int32, UInt32
from std_srvs.srv import Empty

from f1tenth_race_mgr.msg import RaceStatus

BOX = (
    "<robot name='box'><link name='box'><inertial><mass value='1'/>"
    "<inertia ixx='0.1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1'/></inertial>"
    "<collision><geometry><box size='0.1 0.1 0.1'/></geometry></collision>"
    "</link></robot>"
)
SDF_BOX = (
    "<sdf version='1.6'><model name='box'><link name='box'><collision name='box'><geometry>"
    "<box><size>0.1 0.1 0.1</size></box></geometry></collision></link></model></sdf>"
)
INTERVENTIONS = {
    "delete_model",
    "pause_physics",
    "reset_simulation",
    "reset_world",
    "set_model_state",
    "set_physics_properties",
    "spawn_sdf_model",
    "spawn_urdf_model",
    "unpause_physics",
}
AHEAD = Pose(Point(1.0, 0.0, 0.0), Quaternion(0.0, 0.0, 0.0, 1.0))
FAR = Pose(Point(100.0, 100.0, 0.0), Quaternion(0.0, 0.0, 0.0, 1.0))


def call(name, kind, *arguments, **fields):
    return rospy.ServiceProxy(f"/gazebo/{name}", kind)(*arguments, **fields)


def place(model, pose):
    call("set_model_state", SetModelState, ModelState(model_name=model, pose=pose))


def world_models():
    return [name for name in call("get_world_properties", GetWorldProperties).model_names if name != "robot1"]


def at_random(value, chance):
    """A message, or a part of one, with other numbers and words."""
    if isinstance(value, genpy.Message):
        for name in value.__slots__:
            setattr(value, name, at_random(getattr(value, name), chance))
    elif isinstance(value, bool):
        value = chance.choice([False, True])
    elif isinstance(value, (int, float)):
        value = type(value)(chance.randrange(100))
    elif isinstance(value, str):
        value = chance.choice(["robot1", "scenario", "race_starter", "map", "robot1/base_footprint"])
    return value


class Cheating:
    def __init__(self):
        self.count = 0
        self.cheat = getattr(self, rospy.get_param("~how"))
        self.publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=1)
        self.is_driver = rospy.get_param("~is_driver", True)
        self.states = rospy.Publisher("/gazebo/set_model_state", ModelState, queue_size=1)
        rospy.Subscriber("scan", LaserScan, self.on_scan, queue_size=1)

    def on_scan(self, _scan):
        self.count += 1
        if self.count == 200:  # the record is in the file by then
            self.cheat()
        if self.is_driver:
            command = AckermannDriveStamped()
            command.drive.speed = 0.5
            self.publisher.publish(command)

    def drives_on(self):
        pass

    def places_itself(self):
        place("robot1", AHEAD)

    def places_itself_by_the_topic(self):
        self.states.publish(ModelState(model_name="robot1", pose=AHEAD))

    def moves_the_walls(self):
        for model in world_models():
            place(model, FAR)

    def stops_time_meanwhile(self):
        call("pause_physics", Empty)
        call("unpause_physics", Empty)

    def resets_the_world(self):
        call("reset_world", Empty)

    def resets_everything(self):
        call("reset_simulation", Empty)

    def deletes_its_car(self):
        call("delete_model", DeleteModel, "robot1")

    def deletes_the_walls(self):
        for model in world_models():
            call("delete_model", DeleteModel, model)

    def puts_another_thing_in_the_way(self):
        call("spawn_sdf_model", SpawnModel, "box", SDF_BOX, "", FAR, "")

    def puts_something_in_the_way(self):
        call("spawn_urdf_model", SpawnModel, "box", BOX, "", FAR, "")

    def removes_the_logs(self):
        shutil.rmtree(os.environ["ROS_LOG_DIR"])

    def removes_the_record(self):
        os.unlink(rospy.get_param("/sim2d/record"))

    def empties_the_record(self):
        open(rospy.get_param("/sim2d/record"), "w", encoding="utf-8").close()

    def replaces_the_record(self):
        """By a copy that is to be added to when nobody looks."""
        record = Path(rospy.get_param("/sim2d/record"))
        shutil.copy(record, record.with_suffix(".new"))
        record.with_suffix(".new").rename(record)

    def pretends_a_reset(self):
        """After one, the record before it is what counts."""
        record = Path(rospy.get_param("/sim2d/record"))
        shutil.copy(record, f"{record}.before_reset_1")

    def makes_the_record_a_pipe(self):
        self.make_a_pipe_of("record")

    def makes_the_notes_a_pipe(self):
        self.make_a_pipe_of("interventions")

    @staticmethod
    def make_a_pipe_of(name):
        """Whoever opens it would wait for a writer."""
        path = rospy.get_param(f"/sim2d/{name}")
        os.unlink(path)
        os.mkfifo(path)

    def makes_the_logs_pipes(self):
        for path in Path(os.environ["ROS_LOG_DIR"]).glob("*.log"):
            path.unlink()
            os.mkfifo(path)
        os._exit(6)

    def links_the_results(self):
        """So that the judge would write through them."""
        folder = Path(rospy.get_param("/sim2d/record")).parents[1]
        for name in ("result.json", "trajectory.csv", "junit.xml", "run.bag"):
            (folder / name).symlink_to(folder.parent / "victim")

    def leaves_a_daemon(self):
        """It goes on to write what the planner would like to be judged, without our variables."""
        folder = Path(rospy.get_param("/sim2d/record")).parents[1]
        forks = "import os, time\nif os.fork(): os._exit(0)\nos.setsid()\nif os.fork(): os._exit(0)\n"
        writes = f"open({str(folder / 'result.json')!r}, 'w').write('success'); time.sleep(0.02)"
        subprocess.run([sys.executable, "-c", f"{forks}while True: {writes}"], env={}, check=True)

    def tells_the_time_by_another_type(self):
        self.lies = [self.tell("/clock", Header(stamp=rospy.Time(1000)))]

    def adds_a_reset_that_never_was(self):
        """To what the simulator notes: who is out then?"""
        with open(rospy.get_param("/sim2d/interventions"), "a", encoding="utf-8") as stream:
            stream.write('{"time": 1.0, "kind": "reset_world", "caller": "/director", "model": ""}\n')

    def tells_what_the_simulator_did(self):
        """As the simulator's own result."""
        path = Path(rospy.get_param("/sim2d/result_file"))
        path.write_text('{"reason": "shutdown", "trajectory_hash": "0", "sim_time": 1.0}', encoding="utf-8")

    def removes_the_note_of_what_it_does(self):
        os.unlink(rospy.get_param("/sim2d/interventions"))
        self.places_itself()

    def kills_its_proxy(self):
        rosnode.kill_nodes(["/robot1/proxy_driver"])

    def tells_lies(self):
        """What the judge might listen to, and nodes of the run say: nothing of it is so."""
        end, now = rospy.Time(2147483647), rospy.Time.now()
        for line in (
            "[sim2d-2] process has died [pid 7, exit code 3, cmd /x/sim2d].",
            "[robot1/planner-5] process has finished cleanly",
            "REQUIRED process [sim2d-2] has died!\nprocess has finished cleanly",
            "process[sim2d-2]: started with pid [1]",
            "ERROR: cannot launch node of type [x/y]: x",
            "[FATAL] [1.0] [/sim2d]: robot1 drove its laps",
        ):
            print(line, flush=True)
        counts = [KeyValue("accepted", "1000000000"), KeyValue("refused", "1000000000")]
        status = DiagnosticStatus(name="sim2d: commands of robot1", message="refused: x", values=counts)
        self.lies = [  # kept: a publisher that is gone says nothing
            self.tell("/robot1/race_status", RaceStatus(Header(stamp=now), RaceStatus.FINISHED, 99, "")),
            self.tell("/robot1/race_status", RaceStatus(Header(stamp=now), RaceStatus.ABORTED, 0, "no")),
            self.tell("/diagnostics", DiagnosticArray(Header(stamp=now), [status])),
            self.tell("/robot1/collision", Bool(False)),
            self.tell("/robot1/collisions", UInt32(0)),
            self.tell("/robot1/perfect_odom", Odometry(header=Header(stamp=now))),
            self.tell("/robot1/bumper_front", ContactsState(header=Header(stamp=now))),
            self.tell("/gazebo/model_states", ModelStates()),
            self.tell("/robot1/amcl_pose", PoseWithCovarianceStamped(header=Header(stamp=now))),
            self.tell("/time_to_start", Int32(0)),
            self.tell("/sim2d/done", Header(stamp=end, frame_id="scenario")),
            self.tell("/rosout", Log(level=Log.FATAL, name="/sim2d", msg="every lap was driven")),
        ]

    def asks_everybody(self):
        """Calls every service that there is and that is no intervention, with an empty request."""
        master = rosgraph.Master(rospy.get_name())
        for name in sorted(service for service, _nodes in master.getSystemState()[2]):
            if name.rpartition("/")[2] not in INTERVENTIONS:
                self.attempt(name, lambda name=name: rosservice.call_service(name, []))

    def tells_everybody(self):
        """Publishes on every topic that there is, but for its own commands and the clock, at random."""
        known = dict(rosgraph.Master(rospy.get_name()).getTopicTypes())
        rest = {"/clock", "/gazebo/set_model_state", "/robot1/cmd_vel", "/robot1/drive", "/rosout"}
        chance = random.Random(7)
        self.lies = []
        for topic in sorted(known.keys() - rest):
            message = at_random(roslib.message.get_message_class(known[topic])(), chance)
            self.attempt(
                topic, lambda topic=topic, message=message: self.lies.append(self.tell(topic, message))
            )

    def changes_parameters(self):
        """Sets what the run has read, or may read yet."""
        self.attempt("/use_sim_time", lambda: rospy.set_param("/use_sim_time", False))
        for name in rospy.get_param_names():
            if name.startswith(("/sim2d", "/robot1/", "/race_starter", "/map_server")):
                self.attempt(name, lambda name=name: rospy.set_param(name, 0))

    def turns_the_clock_on(self):
        self.lies = [self.tell("/clock", Clock(rospy.Time.now() + rospy.Duration(1000.0)))]

    def adds_to_the_record(self):
        """A lap, by the record's own rows."""
        record = Path(rospy.get_param("/sim2d/record"))
        rows = record.read_text(encoding="utf-8").splitlines(keepends=True)
        with record.open("a", encoding="utf-8") as stream:
            stream.writelines(rows[1:])

    def writes_the_result(self):
        """What it would like to be judged."""
        folder = Path(rospy.get_param("/sim2d/record")).parents[1]
        (folder / "result.json").write_text('{"verdict": "success", "passed": true}', encoding="utf-8")
        (folder / "trajectory.csv").write_text("time\n", encoding="utf-8")

    def answers_for_another(self):
        """As the participant that the simulator waits for."""
        end = rospy.Time(2147483647)
        self.lies = [self.tell("/sim2d/done", Header(stamp=end, frame_id="robot1/proxy_driver"))]

    def starts_the_race(self):
        self.lies = [self.tell("/time_to_start", Int32(0))]

    def stops_the_other_car(self):
        other = "robot2" if rospy.get_namespace() == "/robot1/" else "robot1"
        self.lies = [self.tell(f"/{other}/drive", AckermannDriveStamped())]

    def ends_the_simulator(self):
        rosnode.kill_nodes(["/sim2d"])

    def kills_the_simulator(self):
        os.kill(self.pid_of("/sim2d"), signal.SIGKILL)

    def stops_the_simulator(self):
        os.kill(self.pid_of("/sim2d"), signal.SIGSTOP)

    def ends_the_map(self):
        rosnode.kill_nodes(["/map_server"])

    def ends_the_referee(self):
        """The node with which the judge listens."""
        rosnode.kill_nodes(["/scenario"])

    def takes_the_name_of_the_simulator(self):
        self.start_as("sim2d", "/")

    def takes_the_name_of_the_proxy(self):
        self.start_as("proxy_driver", "/robot1")

    @staticmethod
    def start_as(name, namespace):
        text = f"import rospy; rospy.init_node({name!r}, disable_signals=True); rospy.spin()"
        subprocess.Popen([sys.executable, "-c", text], env={**os.environ, "ROS_NAMESPACE": namespace})

    @staticmethod
    def pid_of(node):
        uri = rosgraph.Master(rospy.get_name()).lookupNode(node)
        return ServerProxy(uri).getPid(rospy.get_name())[2]

    @staticmethod
    def attempt(what, act):
        """Say what is tried; it need not work."""
        print(f"tries {what}", flush=True)
        with contextlib.suppress(Exception):
            act()

    @staticmethod
    def tell(topic, message):
        publisher = rospy.Publisher(topic, type(message), queue_size=1, latch=True)
        publisher.publish(message)
        return publisher

    def changes_the_pace(self):
        now = call("get_physics_properties", GetPhysicsProperties)
        call("set_physics_properties", SetPhysicsProperties, now.time_step, 0.0, now.gravity, now.ode_config)


if __name__ == "__main__":
    rospy.init_node("cheating")
    Cheating()
    rospy.spin()
