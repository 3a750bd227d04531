"""A run without ROS: a program in roslaunch's place that writes what simulator and roslaunch would write."""

import json
import sys
from pathlib import Path

import rosbag
from f1tenth_judge.stop_request import StopRequest
from f1tenth_scenarios.launch.launch_events import PIPE
from f1tenth_scenarios.run.run import execute
from result_schema import valid_result
from scenario_samples import finished, racing, reached, rows, sample_plan, scenario, write_record

SHUTDOWN = f"""\
import json, os, signal, sys
signal.signal(signal.SIGINT, lambda *_: sys.exit(0))
def tell(**event): os.write(int(os.environ[{PIPE!r}]), json.dumps(event).encode() + b"\\n")
"""
READY = "print(flush=True)\n"
STAY = "import time\nwhile True: time.sleep(0.05)\n"


class FakeWatch:
    """Hands out its updates once, as soon as a file is there."""

    def __init__(self, ready: Path, updates=(), failure=None):
        self._ready = ready
        self._updates = list(updates)
        self._failure = failure
        self.closed = False

    def take(self):
        if not self._ready.exists():
            return []
        updates, self._updates = self._updates, []
        return updates

    def failure(self, done):
        return self._failure if self._ready.exists() else None

    def mixed_up(self):
        return None

    def close(self):
        self.closed = True

    def estimates(self):
        return {}

    def descriptions(self):
        return {}


class FakeRun:
    """Builds the program step by step."""

    def __init__(self, folder: Path, wanted=None):
        self.folder = folder
        wanted = wanted or scenario()
        self.plan = sample_plan(folder, wanted, folder / "sample")
        self.ready = folder / "ready"
        self.watch = FakeWatch(self.ready)
        self.stop = StopRequest()
        self._program = SHUTDOWN
        self._sources = 0
        with rosbag.Bag(str(folder / "empty.bag"), "w"):
            pass
        self._do(f"import shutil; shutil.copy({str(folder / 'empty.bag')!r}, {str(self.plan.bag_file)!r})\n")

    def records(self, *arguments, **others):
        self._sources += 1
        source = write_record(self.folder / f"source{self._sources}.csv", rows(*arguments, **others))
        return self._do(self._growing_to(source))

    def _growing_to(self, source):
        """As the simulator's, the record only grows: a copy would be empty for a moment."""
        return (
            f"data = open({str(source)!r}, 'rb').read()\n"
            f"with open({str(self.plan.record_file)!r}, 'ab') as record: record.write(data[record.tell():])\n"
        )

    def is_killed_while_the_simulator_goes_on(self, *arguments, **others):
        """The process that starts all is killed; a moment later the record goes on to what is given."""
        source = write_record(self.folder / "later.csv", rows(*arguments, **others))
        later = f"import time; time.sleep(0.2)\n{self._growing_to(source)}time.sleep(9)"
        self._do(f"import os, subprocess; subprocess.Popen([sys.executable, '-c', {later!r}])\n")
        return self._do("os.kill(os.getpid(), 9)\n")

    def notes_interventions(self, *interventions):
        text = "".join(json.dumps(each) + "\n" for each in interventions)
        return self._do(f"open({str(self.plan.interventions_file)!r}, 'a').write({text!r})\n")

    def resets(self):
        """The simulator begins anew, and keeps its record."""
        path = str(self.plan.record_file)
        return self._do(f"import os; os.rename({path!r}, {path!r} + '.before_reset_1')\n")

    def starts_node(self, name, program="", stopped=False):
        """A process that goes on until the run is over, unless it is stopped."""
        command = f"['setpriv', '--pdeathsig', 'KILL', sys.executable, '-c', {program + READY + STAY!r}]"
        self._do(f"import subprocess; node = subprocess.Popen({command}, stdout=subprocess.PIPE)\n")
        self._do("node.stdout.readline()\n")
        if stopped:
            self._do("node.send_signal(signal.SIGSTOP)\n")
        return self._do(f"tell(event='started', process='{name}-1', pid=node.pid)\n")

    def ends_node(self, name, exit_code, **others):
        return self._do(f"tell(event='ended', process='{name}-1', exit_code={exit_code}, **{others})\n")

    def loses_its_bag(self):
        return self._do(f"import os; os.unlink({str(self.plan.bag_file)!r})\n")

    def waits(self, seconds):
        return self._do(f"import time; time.sleep({seconds})\n")

    def simulator_says(self, **result):
        path, text = str(self.plan.simulator_result_file), json.dumps(result)
        return self._do(f"open({path!r}, 'w').write({text!r})\n")

    def prints(self, text):
        return self._do(f"print({text!r}, flush=True)\n")

    def hears(self, *updates, failure=None):
        self.watch = FakeWatch(self.ready, updates, failure)
        return self._do(f"open({str(self.ready)!r}, 'w').close()\n")

    def ends(self, exit_code):
        return self._do(f"sys.exit({exit_code})\n")

    def execute(self, **others):
        command = [sys.executable, "-c", self._program + STAY]
        return execute(self.plan, command, {}, lambda: self.watch, self.stop, **others)

    def _do(self, line):
        self._program += line
        return self


def succeeding(folder):
    """A run that passes every goal."""
    run = FakeRun(folder).records(1.0).waits(0.5).records(9.0)
    return run.hears(racing(), reached(2.2, 1), reached(2.5, 2), finished(3.0))


def result_of(run, **others):
    """What result.json says when a run is over."""
    run.execute(**others)
    return valid_result(run.plan.folder / "result.json")
