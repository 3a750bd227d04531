"""The process that starts the nodes of a run, and ends them."""

import os
import signal
import sys

import psutil
import pytest
from f1tenth_scenarios.launch.private_master import private_master
from f1tenth_scenarios.launch.processes import ProcessTree
from f1tenth_scenarios.run.launch_log import LaunchLog
from patience import PATIENCE, wait_for

STAYS = "#!/bin/sh\nexec sleep 600\n"
DEAF = "#!/bin/sh\ntrap '' INT; touch {folder}/deaf; while true; do sleep 0.05; done"
PYTHON = "#!/usr/bin/env python3\nimport sys, time\n"
# A package whose nodes are scripts.
MANIFEST = """<package format="2"><name>sample</name><version>1.0.0</version><description>x</description>
<maintainer email="a@b.c">a</maintainer><license>x</license></package>"""


@pytest.fixture
def launch(tmp_path):
    """Starts the launch process with some nodes: their scripts by name; the attributes of all of them."""
    trees = []

    def start(scripts, attributes="", parameters=""):
        folder = tmp_path / "sample"
        folder.mkdir()
        (folder / "package.xml").write_text(MANIFEST, encoding="utf-8")
        for name, script in scripts.items():
            (folder / name).write_text(script.replace("{folder}", str(tmp_path)))
            (folder / name).chmod(0o755)
        nodes = "".join(
            f'<node pkg="sample" type="{name}" name="{name}" output="screen" {attributes}/>'
            for name in scripts
        )
        file = tmp_path / "run.launch"
        file.write_text(f"<launch>{parameters}{nodes}</launch>", encoding="utf-8")
        command = [sys.executable, "-m", "f1tenth_scenarios.launch.launch_process", str(file)]
        environment = {
            "ROS_PACKAGE_PATH": str(tmp_path),
            "ROS_LOG_DIR": str(tmp_path),
            "PYTHONUNBUFFERED": "1",
        }
        trees.append(ProcessTree(command, tmp_path / "log", environment))
        return trees[-1], Log(tmp_path / "log")

    with private_master():
        yield start
        for tree in trees:
            tree.stop(PATIENCE)


class Log(LaunchLog):
    """What the launch process wrote."""

    def __init__(self, path):
        super().__init__(path)
        self.path = path

    def pid_of(self, name):
        return wait_for(lambda: self.poll() or self.pids.get(name))

    def end_of(self, name):
        (end,) = wait_for(lambda: self.poll() or [each for each in self.ends if each.node == name])
        return end

    @property
    def text(self):
        return self.path.read_text(encoding="utf-8")


def wait_for_end(tree):
    wait_for(lambda: tree.exit_code() is not None)
    return tree.exit_code()


def test_nodes_run_from_the_line_to_the_signal(launch):
    tree, log = launch({"one": STAYS, "two": STAYS})
    tree.go()
    pids = [log.pid_of("one"), log.pid_of("two")]
    tree.interrupt(None, PATIENCE)
    assert wait_for_end(tree) == 0
    assert not any(psutil.pid_exists(pid) for pid in pids)
    log.poll()
    assert log.ends == []


def test_nothing_runs_if_the_line_does_not_come(launch):
    tree, log = launch({"one": STAYS})
    tree.interrupt(None, PATIENCE)
    assert wait_for_end(tree) in (0, -signal.SIGINT)
    assert log.text == ""


def test_parameters_are_set_before_the_nodes_run(launch, tmp_path):
    python = "import os, rosgraph; print('colour', rosgraph.Master('/x').getParam('/colour'))"
    tree, log = launch(
        {"one": f'#!/bin/sh\nexec /usr/bin/python3 -c "{python}"\n'},
        parameters='<param name="colour" value="red"/>',
    )
    tree.go()
    assert wait_for_end(tree) == 0
    assert "colour red" in log.text


def test_node_that_dies_is_reported_and_the_others_go_on(launch):
    tree, log = launch({"dies": "#!/bin/sh\nexit 7\n", "stays": STAYS})
    tree.go()
    assert log.end_of("dies").exit_code == 7
    assert psutil.pid_exists(log.pid_of("stays"))
    assert tree.exit_code() is None


def test_killed_node_is_reported_with_its_signal(launch):
    tree, log = launch({"one": STAYS, "two": STAYS})
    tree.go()
    os.kill(log.pid_of("one"), signal.SIGKILL)
    assert log.end_of("one").describe() == "was killed by signal 9"


def test_end_of_a_required_node_ends_all(launch):
    tree, log = launch({"stays": STAYS, "dies": "#!/bin/sh\nexit 3\n"}, attributes='required="true"')
    tree.go()
    assert wait_for_end(tree) == 0
    assert log.end_of("dies").exit_code == 3
    assert not psutil.pid_exists(log.pid_of("stays"))


def test_end_of_the_last_node_is_the_end(launch):
    tree, log = launch({"one": "#!/bin/sh\nexit 0\n"})
    tree.go()
    assert wait_for_end(tree) == 0
    assert log.end_of("one").exit_code == 0


def test_node_that_ignores_the_signal_is_made_to_end(launch, tmp_path):
    tree, log = launch({"deaf": DEAF, "stays": STAYS})
    tree.go()
    wait_for((tmp_path / "deaf").exists)
    pid = log.pid_of("deaf")
    tree.interrupt(None, PATIENCE)
    assert wait_for_end(tree) == 0
    assert not psutil.pid_exists(pid)


@pytest.mark.parametrize(
    ("ending", "exit_code", "said"),
    [
        ("pass", 0, ""),
        ("sys.exit(3)", 3, ""),
        ("sys.exit('no such goal')", 1, "no such goal"),
        ("raise ValueError('wrong')", 1, "ValueError: wrong"),
    ],
)
def test_python_node_ends_as_in_an_interpreter_of_its_own(launch, ending, exit_code, said):
    at_exit = "import atexit; atexit.register(print, 'last words')\n"
    tree, log = launch({"one": f"{PYTHON}{at_exit}{ending}\n"})
    tree.go()
    assert wait_for_end(tree) == 0
    assert log.end_of("one").exit_code == exit_code
    assert said in log.text
    assert "last words" in log.text


def test_python_node_finds_itself_alone(launch, tmp_path):
    looks = (
        "import os, signal\n"
        "print('name', __name__, sys.argv[0], sys.argv[1], sys.path[0])\n"
        "print('rospy', 'rospy' in sys.modules, 'session', os.getsid(0) == os.getpid())\n"
        "print('signal', signal.getsignal(signal.SIGINT) is signal.default_int_handler)\n"
        "print('open', sorted(os.listdir('/proc/self/fd'))[:-1])\n"
    )
    tree, log = launch({"one": PYTHON + looks})
    tree.go()
    assert wait_for_end(tree) == 0
    folder = tmp_path / "sample"
    assert f"name __main__ {folder}/one __name:=one {folder}\n" in log.text
    assert "rospy False session True\nsignal True\nopen ['0', '1', '2']\n" in log.text


def test_python_node_ends_with_the_others(launch):
    tree, log = launch({"python": f"{PYTHON}print('up', flush=True)\ntime.sleep(600)\n", "shell": STAYS})
    tree.go()
    pids = [log.pid_of("python"), log.pid_of("shell")]
    wait_for(lambda: "up" in log.text)
    tree.interrupt(None, PATIENCE)
    assert wait_for_end(tree) == 0
    assert not any(psutil.pid_exists(pid) for pid in pids)


@pytest.mark.parametrize(
    ("content", "answer"),
    [
        (
            '<node pkg="sample" type="none" name="x"/>',
            "Cannot locate node of type [none] in package [sample]",
        ),
        ('<include file="/none.launch"/>', "/none.launch"),
        ('<param name="x" command="false"/>', "returned with code [1]"),
    ],
)
def test_launch_file_that_cannot_be_used_is_answered(launch, content, answer):
    tree, log = launch({}, parameters=content)
    tree.go()
    assert wait_for_end(tree) == 1
    assert answer in log.text
    assert "Traceback" not in log.text
