#!/usr/bin/env python3
"""empty_world.launch paused, and spawn_model as a command."""

import os
import subprocess
import unittest
import xmlrpc.client

import rosgraph
import rospkg
import rospy
import rostest
from gazebo_msgs.srv import GetModelState, GetPhysicsProperties, GetWorldProperties, SpawnModel
from rosgraph_msgs.msg import Clock

LONG = 60.0  # wall s: only a hang takes that long
CONE = """<sdf version="1.6"><model name="cone"><link name="link">
<inertial><mass>0.5</mass></inertial>
<collision name="c"><geometry>
<cylinder><radius>0.1</radius><length>0.3</length></cylinder></geometry></collision>
</link></model></sdf>"""


def command():
    """Return the path of the command."""
    paths = [
        os.path.join(p, "lib", "gazebo_ros", "spawn_model")
        for p in os.environ["CMAKE_PREFIX_PATH"].split(":")
    ]
    paths.append(os.path.join(rospkg.RosPack().get_path("gazebo_ros"), "scripts", "spawn_model"))
    return next(path for path in paths if os.access(path, os.X_OK))


def spawn_model(*arguments, text=None):
    """Run the command; return its exit code and what it said."""
    done = subprocess.run([command(), *arguments], input=text, capture_output=True, text=True, timeout=LONG)
    return done.returncode, done.stdout + done.stderr


def end_bond(*arguments):
    """Run the command with -b, and end it once the cone is there; return its exit code and what it said.

    It is ended as `rosnode kill` does: rospy hangs in the handler of a signal that comes while it logs.
    """
    process = subprocess.Popen(
        [command(), "-sdf", "-stdin", "-model", "bound", "-b", "__name:=bond", *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, "PYTHONUNBUFFERED": "1"},
    )
    try:
        process.stdin.write(CONE)
        process.stdin.close()
        said = []
        for line in process.stdout:
            said.append(line)
            if "SpawnModel: " in line:
                node = rosgraph.Master(rospy.get_name()).lookupNode("/bond")
                xmlrpc.client.ServerProxy(node).shutdown(rospy.get_name(), "end of the test")
        return process.wait(LONG), "".join(said)
    finally:
        process.kill()


def call(name, kind, *arguments):
    rospy.wait_for_service("/gazebo/" + name, LONG)
    return rospy.ServiceProxy("/gazebo/" + name, kind)(*arguments)


class SpawnModelTest(unittest.TestCase):
    def test_empty_world_is_paused_until_a_model_is_there(self):
        assert call("get_world_properties", GetWorldProperties).model_names == ["ground_plane"]
        assert call("get_physics_properties", GetPhysicsProperties).pause
        code, said = spawn_model(
            "-sdf", "-stdin", "-model", "cone1", "-x", "2", "-Y", "0.5", "-unpause", text=CONE
        )
        assert code == 0, said
        assert "SpawnModel: Successfully spawned entity" in said
        state = call("get_model_state", GetModelState, "cone1", "")
        assert abs(state.pose.position.x - 2.0) < 1e-6
        assert rospy.wait_for_message("/clock", Clock, LONG).clock.to_nsec() > 0
        code, said = spawn_model("-sdf", "-stdin", "-model", "cone1", text=CONE)
        assert code == 1
        assert "SpawnModel: Failure - model name cone1 already exist." in said

    def test_bond_deletes_the_model_at_the_end(self):
        code, said = end_bond()
        assert code == 0, said
        assert "bound" not in call("get_world_properties", GetWorldProperties).model_names

    def test_bond_ends_also_when_the_simulator_is_gone(self):
        answer = (True, "SpawnModel: done")
        service = rospy.Service("/gone/spawn_sdf_model", SpawnModel, lambda request: answer)
        self.addCleanup(service.shutdown)
        code, said = end_bond("-gazebo_namespace", "/gone")
        assert code == 0, said
        assert "model bound was not deleted: " in said

    def test_mistakes_are_one_line(self):
        for arguments, text, line in (
            (["-urdf", "-param", "no_such", "-model", "m"], None, "spawn_model: no parameter /no_such"),
            (
                ["-urdf", "-file", "/no/such", "-model", "m"],
                None,
                "spawn_model: cannot read /no/such: No such file",
            ),
            (["-urdf", "-stdin", "-model", "m"], "<robot", "spawn_model: the description is not XML: "),
            (
                ["-urdf", "-model", "m"],
                None,
                "spawn_model: one of the arguments -param -file -database -stdin is",
            ),
        ):
            code, said = spawn_model(*arguments, text=text)
            assert code == 2, said
            assert line in said
            assert "Traceback" not in said


if __name__ == "__main__":
    rospy.init_node("spawn_model_test", disable_rostime=True)
    rostest.rosrun("gazebo_ros", "spawn_model", SpawnModelTest)
