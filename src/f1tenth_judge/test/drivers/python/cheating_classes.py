"""Planners that drive straight on, and do to the judge's files and processes what no driver may."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from f1tenth_judge.planner import Command

# Without our variables, in a session of its own, as a daemon.
DAEMON = """
import os, sys, time
if os.fork(): os._exit(0)
os.setsid()
if os.fork(): os._exit(0)
while True:
    for name in sys.argv[2:]:
        try: open(name, 'w').write('{"verdict": "success"}')
        except OSError: pass
    time.sleep(0.02)
"""


class Straight:
    """Cheats once, in the period at 0.2 s."""

    logs = Path(os.readlink("/proc/self/fd/1")).parent  # where its output goes
    is_done = False

    def plan(self, observation):
        if observation.time >= 0.2 and not self.is_done:
            self.is_done = True
            self.cheat()
        return Command(0.2, 0.0)

    @property
    def record(self):
        return self.logs / "record.csv"


class ReplacesTheRecord(Straight):
    def cheat(self):
        shutil.copy(self.record, self.logs / "new")
        os.replace(self.logs / "new", self.record)


class OverwritesTheRecord(Straight):
    def cheat(self):
        rows = self.record.read_text().splitlines(keepends=True)
        self.record.write_text("".join([rows[0], *[row.replace(",0.", ",1.") for row in rows[1:]]]))


class AddsToTheRecord(Straight):
    def cheat(self):
        last = self.record.read_text().splitlines()[-1]
        with self.record.open("a") as stream:
            stream.write(last.replace("0.2,", "9.9,", 1) + "\n")


class RemovesTheRecord(Straight):
    def cheat(self):
        self.record.unlink()


class RemovesAllFiles(Straight):
    def cheat(self):
        shutil.rmtree(self.logs.parent)


class PutsAFileInPlaceOfTheFolder(RemovesAllFiles):
    def cheat(self):
        super().cheat()
        self.logs.parent.touch()


class PutsAPipeThere(Straight):
    def cheat(self):
        self.record.unlink()
        os.mkfifo(self.record)


class PutsAFolderThere(Straight):
    def cheat(self):
        self.record.unlink()
        self.record.mkdir()


class PutsADeviceThere(Straight):
    def cheat(self):
        self.record.unlink()
        self.record.symlink_to("/dev/zero")


class LogsIntoAPipe(Straight):
    def cheat(self):
        log = self.logs / "robot1.log"
        log.unlink()
        os.mkfifo(log)
        os._exit(5)


class LinksTheResults(Straight):
    """So that the judge would write through them."""

    def cheat(self):
        for name in ("result.json", "trajectory.csv", f".result.json.{os.getppid()}.json"):
            (self.logs.parent / name).symlink_to(self.logs.parent.parent / "victim")


class WritesTheResult(Straight):
    def cheat(self):
        (self.logs.parent / "result.json").write_text('{"verdict": "success", "passed": true}')


class LeavesADaemon(Straight):
    """It goes on to write what the planner would like to be judged."""

    def cheat(self):
        files = [str(self.logs.parent / "result.json"), str(self.record)]
        subprocess.run([sys.executable, "-c", DAEMON, "f1tenth_daemon", *files], env={}, check=True)


class PatchesItsOwnModules(Straight):
    """Of the judge and the simulator, which are not those of the judge's process."""

    def cheat(self):
        import f1tenth_judge.judge.judge as judge
        import f1tenth_judge.judge.laps as laps

        import f1tenth_sim2d

        for module in (judge, laps, f1tenth_sim2d):
            for name in [each for each in dir(module) if not each.startswith("__")]:
                setattr(module, name, lambda *_arguments, **_others: True)
        os.environ.update(LD_PRELOAD="/nowhere.so", PYTHONPATH="/nowhere", F1TENTH_RESULTS="/nowhere")


class KillsTheJudge(Straight):
    def cheat(self):
        os.kill(os.getppid(), 9)
