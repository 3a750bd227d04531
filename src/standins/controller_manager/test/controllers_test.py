#!/usr/bin/env python3
"""The commands of this package with the controllers of the simulator."""

import contextlib
import io
import math
import os
import signal
import subprocess
import threading
import unittest

import rospy
import rostest
from commands import LONG, command_path, run_until
from controller_manager import controller_manager_interface
from controller_manager.command_line import COMMANDS
from controller_manager_msgs.srv import ListControllers, ListControllerTypes, SwitchController
from diagnostic_msgs.msg import DiagnosticArray
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64
from std_srvs.srv import Empty

MANAGER = "/racecar/controller_manager/"


class Watch:
    """Keeps the messages of a topic."""

    def __init__(self, topic, kind):
        self._changed = threading.Condition()
        self._messages = []
        self._subscriber = rospy.Subscriber(topic, kind, self._keep)

    def _keep(self, message):
        with self._changed:
            self._messages.append(message)
            self._changed.notify_all()

    def newest(self, condition=lambda message: True):
        """Return the newest message for which the condition holds; None if there is none."""
        return next((message for message in reversed(self._messages) if condition(message)), None)

    def wait_for(self, condition=lambda message: True):
        """Wait for a message for which the condition holds, and return the newest."""
        with self._changed:
            assert self._changed.wait_for(lambda: self.newest(condition) is not None, LONG), self.newest()
            return self.newest(condition)

    def close(self):
        self._subscriber.unregister()


class ControllersTest(unittest.TestCase):
    def setUp(self):
        controller_manager_interface.use_namespace("/racecar")
        rospy.wait_for_service(MANAGER + "switch_controller", LONG)
        self.processes = []
        self.addCleanup(self.end_all)

    def end_all(self):
        for process in self.processes:
            self.end(process)
        for state in list(self.controllers()):
            self.manager("kill" if self.controllers()[state] == "running" else "unload", state)
        rospy.ServiceProxy("/gazebo/reset_simulation", Empty)()

    def end(self, process):
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
            process.wait(LONG)

    def start(self, name, *arguments, namespace="racecar"):
        environment = {**os.environ, "ROS_NAMESPACE": namespace}
        self.processes.append(subprocess.Popen([command_path(name), *arguments], env=environment))
        return self.processes[-1]

    def manager(self, command, *names):
        """Do what the command controller_manager does; return its exit code and output."""
        with contextlib.redirect_stdout(io.StringIO()) as output:
            done = COMMANDS[command](names)
        return (0 if done else 1), output.getvalue().strip()

    def controllers(self):
        answer = rospy.ServiceProxy(MANAGER + "list_controllers", ListControllers)()
        return {state.name: state.state for state in answer.controller}

    def wait_until(self, states):
        while self.controllers() != states:
            assert not rospy.is_shutdown()

    def watch(self, topic, kind):
        watch = Watch(topic, kind)
        self.addCleanup(watch.close)
        return watch

    def log(self):
        """What the simulator says, from when it is heard."""
        log = self.watch("/rosout", Log)
        while not log.newest(lambda message: "not_there" in message.msg):
            self.manager("load", "not_there")
        return log

    def command(self, controller):
        publisher = rospy.Publisher(f"/racecar/{controller}/command", Float64, queue_size=1)
        self.addCleanup(publisher.unregister)
        while not publisher.get_num_connections():
            assert not rospy.is_shutdown()
        return publisher

    def test_spawner_starts_controllers_that_move_the_car_and_takes_them_away(self):
        spawner = self.start("spawner", "states", "rear_left", "rear_right", "steer_left", "steer_right")
        self.wait_until(
            dict.fromkeys(("states", "rear_left", "rear_right", "steer_left", "steer_right"), "running")
        )
        joints = self.watch("/racecar/joint_states", JointState)
        for side in ("left", "right"):
            self.command(f"rear_{side}").publish(10.0)
            self.command(f"steer_{side}").publish(0.2)

        def turns(message):
            velocity = dict(zip(message.name, message.velocity))
            position = dict(zip(message.name, message.position))
            return (
                8.0 < velocity["left_rear_wheel_joint"] < velocity["right_rear_wheel_joint"]
                and 0.18 < position["right_steering_joint"] < position["left_steering_joint"] < 0.22
            )

        joints.wait_for(turns)
        self.end(spawner)
        assert self.controllers() == {}

    def test_joint_states_come_once_however_often_their_controller_was_loaded(self):
        times = []
        subscriber = rospy.Subscriber(
            "/racecar/joint_states", JointState, lambda message: times.append(message.header.stamp)
        )
        self.addCleanup(subscriber.unregister)
        for _ in range(2):
            assert self.manager("spawn", "states")[0] == 0
            seen = len(times)
            while len(times) < seen + 10:
                assert not rospy.is_shutdown()
            assert self.manager("kill", "states")[0] == 0
        assert len(set(times)) == len(times)

    def test_torque_accelerates_the_car(self):
        assert self.manager("spawn", "states", "rear_left_motor")[0] == 0
        joints = self.watch("/racecar/joint_states", JointState)
        self.command("rear_left_motor").publish(0.5)
        joints.wait_for(lambda message: min(message.velocity) >= 0.0 and max(message.velocity) > 10.0)

    def test_stopped_controllers_are_loaded_only(self):
        self.start("spawner", "--stopped", "rear_left")
        self.wait_until({"rear_left": "initialized"})
        assert self.manager("start", "rear_left") == (0, "Started rear_left successfully")
        environment = {**os.environ, "ROS_NAMESPACE": "racecar"}
        listing = subprocess.run(
            [command_path("controller_manager"), "list"], env=environment, capture_output=True, text=True
        )
        assert listing.returncode == 0
        assert listing.stdout == "'rear_left' - 'velocity_controllers/JointVelocityController' ( running )\n"
        assert self.manager("unload", "rear_left") == (1, "Error when unloading 'rear_left'")
        assert self.manager("stop", "rear_left")[0] == 0
        assert self.controllers() == {"rear_left": "stopped"}

    def test_unspawner_stops_and_starts_again(self):
        assert self.manager("spawn", "rear_left")[0] == 0
        unspawner = self.start("unspawner", "--namespace", "/racecar", "rear_left", namespace="/")
        self.wait_until({"rear_left": "stopped"})
        self.end(unspawner)
        assert self.controllers() == {"rear_left": "running"}

    def test_wrong_parameters_are_named(self):
        log = self.log()
        for name, said in {
            "without_joint": "parameter /racecar/without_joint/joint: "
            "not set, must be a text that is not empty",
            "turned_wheel": "controller turned_wheel: position_controllers/JointPositionController "
            "cannot move left_rear_wheel_joint, which is a wheel: these take velocities or efforts",
        }.items():
            assert self.manager("load", name) == (1, f"Error when loading '{name}'")
            log.wait_for(lambda message, said=said: message.msg == said)

    def test_gains_that_are_not_simulated_are_named(self):
        log = self.log()
        assert self.manager("load", "rear_right")[0] == 0
        said = (
            "controller rear_right: its pid gains are not simulated, "
            "right_rear_wheel_joint follows as fast as the car can"
        )
        log.wait_for(lambda message: message.msg == said)

    def test_a_controller_claims_its_joint_at_its_interface(self):
        assert self.manager("load", "rear_left_motor")[0] == 0
        (motor,) = rospy.ServiceProxy(MANAGER + "list_controllers", ListControllers)().controller
        assert [(claim.hardware_interface, claim.resources) for claim in motor.claimed_resources] == [
            ("hardware_interface::EffortJointInterface", ["left_rear_wheel_joint"])
        ]

    def test_controllers_that_cannot_be_are_refused(self):
        for name in ("no_joint", "no_type", "unknown_type", "not_there"):
            assert self.manager("load", name) == (1, f"Error when loading '{name}'")
        assert self.manager("load", "rear_left")[0] == 0
        assert self.manager("load", "rear_left")[0] == 1
        assert self.manager("start", "steer_left")[0] == 1

    def test_a_joint_has_one_controller(self):
        for name in ("rear_left", "rear_left_motor"):
            assert self.manager("load", name)[0] == 0
        assert self.manager("start", "rear_left")[0] == 0
        assert self.manager("start", "rear_left_motor")[0] == 1
        switch = rospy.ServiceProxy(MANAGER + "switch_controller", SwitchController)
        best_effort = 1
        assert not switch(["rear_left_motor"], [], best_effort, False, 0.0).ok
        assert switch(["no_such", "rear_left"], ["rear_left_motor"], best_effort, False, 0.0).ok
        assert self.controllers() == {"rear_left": "running", "rear_left_motor": "initialized"}
        assert switch(["rear_left_motor"], ["rear_left"], 2, False, 0.0).ok
        assert switch([], ["rear_left_motor"], 2, False, 0.0).ok
        assert not switch(["rear_left", "rear_left_motor"], [], best_effort, False, 0.0).ok
        assert self.controllers() == {"rear_left": "stopped", "rear_left_motor": "stopped"}
        assert switch(["rear_left_motor", "rear_left_motor"], [], 2, False, 0.0).ok
        assert self.controllers() == {"rear_left": "stopped", "rear_left_motor": "running"}

    def test_absurd_commands_are_refused_and_counted(self):
        diagnostics = self.watch("/diagnostics", DiagnosticArray)
        assert self.manager("spawn", "rear_left")[0] == 0
        self.command("rear_left").publish(math.nan)

        def is_counted(message):
            status = {status.name: status for status in message.status}["sim2d: commands of racecar"]
            return status.level == 1 and "left_rear_wheel_joint: commanded nan" in status.message

        diagnostics.wait_for(is_counted)

    def test_what_several_joints_are_told_at_a_time_counts_once(self):
        def accepted(message):
            status = {status.name: status for status in message.status}["sim2d: commands of racecar"]
            return int({entry.key: entry.value for entry in status.values}["accepted"])

        diagnostics = self.watch("/diagnostics", DiagnosticArray)
        names = ("rear_left", "rear_right")
        assert self.manager("spawn", *names)[0] == 0
        before = accepted(diagnostics.wait_for())
        for publisher in [self.command(name) for name in names]:
            publisher.publish(1.0)
        after = accepted(diagnostics.wait_for(lambda message: accepted(message) > before))
        assert after - before <= len(names)

    def test_spawner_names_only_what_it_has_started(self):
        code, said = run_until(
            "Started controllers", "spawner", "unknown_type", "rear_left", namespace="racecar"
        )
        assert code == 2
        assert "Failed to load unknown_type" in said
        assert "Started controllers: rear_left\n" in said

    def test_spawner_in_another_namespace_names_the_managers_that_there_are(self):
        code, said = run_until(
            "No controller manager", "spawner", "rear_left", "--timeout", "0.5", namespace="car"
        )
        assert code == 1
        assert "Waiting for /car/controller_manager" in said
        assert "No controller manager /car/controller_manager within 0.5 s; " in said
        assert "there are: /racecar/controller_manager" in said

    def test_types_that_can_be_loaded(self):
        types = rospy.ServiceProxy(MANAGER + "list_controller_types", ListControllerTypes)().types
        assert types == [
            "joint_state_controller/JointStateController",
            "velocity_controllers/JointVelocityController",
            "velocity_controllers/JointPositionController",
            "position_controllers/JointPositionController",
            "effort_controllers/JointEffortController",
            "effort_controllers/JointVelocityController",
            "effort_controllers/JointPositionController",
        ]


if __name__ == "__main__":
    rospy.init_node("controllers_test")
    rostest.rosrun("controller_manager", "controllers", ControllersTest)
