"""roslaunch as it starts the nodes of a run and ends them, and what it tells."""

import os
import signal

import psutil
import pytest
from f1tenth_judge.run.processes import ProcessTree
from f1tenth_scenarios.launch.launch_events import LaunchEvents
from f1tenth_scenarios.launch.launch_file import launch_command
from f1tenth_scenarios.launch.private_master import private_master
from patience import PATIENCE, wait_for

STAYS = "#!/bin/sh\nexec sleep 600\n"
DEAF = "#!/bin/sh\ntrap '' INT; touch {folder}/deaf; while true; do sleep 0.05; done"
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
        environment = {
            "ROS_PACKAGE_PATH": str(tmp_path),
            "ROS_LOG_DIR": str(tmp_path),
            "PYTHONUNBUFFERED": "1",
        }
        events = Events(tmp_path / "log")
        environment |= events.variables
        trees.append(ProcessTree(launch_command(file), events.log, environment, [events.pipe]))
        return trees[-1], events

    with private_master():
        yield start
        for tree in trees:
            tree.stop(PATIENCE)


class Events(LaunchEvents):
    """What the launch process told, and its output."""

    def __init__(self, log):
        super().__init__()
        self.log = log

    def pid_of(self, name):
        return wait_for(lambda: self.poll() or self.pids.get(name))

    def end_of(self, name):
        (end,) = wait_for(lambda: self.poll() or [each for each in self.ends if each.node == name])
        return end

    @property
    def text(self):
        return self.log.read_text(encoding="utf-8")


def wait_for_end(tree):
    wait_for(lambda: tree.exit_code() is not None)
    return tree.exit_code()


def test_nodes_run_until_the_signal(launch):
    tree, log = launch({"one": STAYS, "two": STAYS})
    pids = [log.pid_of("one"), log.pid_of("two")]
    tree.interrupt(None, PATIENCE)
    assert wait_for_end(tree) == 0
    assert not any(psutil.pid_exists(pid) for pid in pids)
    log.poll()
    assert log.ends == []


def test_parameters_are_set_before_the_nodes_run(launch, tmp_path):
    python = "import os, rosgraph; print('colour', rosgraph.Master('/x').getParam('/colour'))"
    tree, log = launch(
        {"one": f'#!/bin/sh\nexec /usr/bin/python3 -c "{python}"\n'},
        parameters='<param name="colour" value="red"/>',
    )
    assert wait_for_end(tree) == 0
    assert "colour red" in log.text


def test_node_that_dies_is_reported_and_the_others_go_on(launch):
    tree, log = launch({"dies": "#!/bin/sh\nexit 7\n", "stays": STAYS})
    assert log.end_of("dies").exit_code == 7
    assert psutil.pid_exists(log.pid_of("stays"))
    assert tree.exit_code() is None


def test_killed_node_is_reported_with_its_signal(launch):
    tree, log = launch({"one": STAYS, "two": STAYS})
    os.kill(log.pid_of("one"), signal.SIGKILL)
    assert log.end_of("one").describe() == "was killed by signal 9"


def test_end_of_a_required_node_ends_all(launch):
    tree, log = launch({"stays": STAYS, "dies": "#!/bin/sh\nexit 3\n"}, attributes='required="true"')
    assert wait_for_end(tree) == 0
    assert log.end_of("dies").exit_code == 3
    assert not psutil.pid_exists(log.pid_of("stays"))


def test_words_of_a_node_are_no_events(launch):
    said = "printf '[two-2] process has died [pid 3, exit code 9, cmd x].\\n'"
    everywhere = f"for file in 3 4 5 6 7 8 9; do ({said} >&$file) 2>/dev/null; done"
    tree, log = launch({"two": STAYS, "one": f"#!/bin/sh\n{said}; {everywhere}; exit 4\n"})
    assert log.end_of("one").exit_code == 4
    assert [end.node for end in log.ends] == ["one"]
    assert "[two-2] process has died" in log.text


def test_node_that_is_started_anew_ends_once_each_time(launch, tmp_path):
    once = "#!/bin/sh\ntest -e {folder}/again && exec sleep 600; touch {folder}/again; exit 7\n"
    tree, log = launch({"one": once}, attributes='respawn="true" respawn_delay="0.5"')
    wait_for((tmp_path / "again").exists)
    wait_for(lambda: "restarting process" in log.text)
    assert log.end_of("one").exit_code == 7


def test_end_of_the_last_node_is_the_end(launch):
    tree, log = launch({"one": "#!/bin/sh\nexit 0\n"})
    assert wait_for_end(tree) == 0
    assert log.end_of("one").exit_code == 0


def test_node_that_ignores_the_signal_is_made_to_end(launch, tmp_path):
    tree, log = launch({"deaf": DEAF, "stays": STAYS})
    wait_for((tmp_path / "deaf").exists)
    pid = log.pid_of("deaf")
    log.pid_of("stays")  # a launch that is interrupted while it starts nodes ends with exit code 1
    tree.interrupt(None, PATIENCE)
    assert wait_for_end(tree) == 0
    assert not psutil.pid_exists(pid)


@pytest.mark.parametrize(
    ("node", "culprit", "reason"),
    [
        ('pkg="sample" type="none"', "sample/none", "Cannot locate node of type [none] in package [sample]"),
        ('pkg="nobody" type="none"', "nobody/none", "there is no package nobody"),
    ],
)
def test_node_that_cannot_be_started_is_named(launch, node, culprit, reason):
    tree, log = launch({"stays": STAYS}, parameters=f'<node {node} name="x"/>')
    assert log.end_of(culprit).describe().startswith(f"cannot be started: {reason}")
    assert tree.exit_code() is None


@pytest.mark.parametrize(
    ("content", "answer"),
    [
        ('<include file="/none.launch"/>', "/none.launch"),
        ('<param name="x" command="false"/>', "returned with code [1]"),
    ],
)
def test_launch_file_that_cannot_be_used_is_answered(launch, content, answer):
    tree, log = launch({}, parameters=content)
    assert wait_for_end(tree) == 1
    assert answer in log.text
    assert "Traceback" not in log.text
