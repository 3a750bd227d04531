"""A command that is started in order to break it, and everything that it has started."""

import contextlib
import dataclasses
import json
import os
import subprocess
import time
import uuid
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Optional

import psutil
from f1tenth_scenarios.launch.processes import processes_with

MOST_SECONDS = 5.0  # wall, from the verdict or a request to stop, until nothing runs any more
RUNNER = "runner"  # what the command itself is called
_MARK = "F1TENTH_FAULT"  # every descendant inherits it
_LOOK_INTERVAL = 0.02  # wall s
_KILL_PATIENCE = 10.0  # wall s, until what is killed is gone


@dataclasses.dataclass(frozen=True)
class Ending:
    """How a command ended."""

    exit_code: Optional[int]  # nothing if it had to be killed
    seconds: float  # wall, from the fault until none of its processes ran
    seconds_after: float  # the same from when the verdict was written; from the fault without one
    result: Optional[dict[str, Any]]  # its result.json
    has_junit: bool
    said: str  # on the terminal


class Victim:
    """A command with its results in a folder, that can be broken."""

    def __init__(self, command: Sequence[str], results: Path, said: Path, **popen: Any):
        """Start it; its terminal output goes to the file `said`."""
        self.results = self.written = results  # found afterwards; written to
        self.beside: list[subprocess.Popen] = []  # what was started to disturb it, and ends with it
        self._mark = uuid.uuid4().hex
        self._output = open(said, "w+", encoding="utf-8")  # noqa: SIM115
        environment = {**os.environ, **popen.pop("env", {}), _MARK: self._mark}
        self.process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=self._output,
            stderr=subprocess.STDOUT,
            env=environment,
            start_new_session=True,
            **popen,
        )

    def __enter__(self) -> "Victim":
        return self

    def __exit__(self, *_: object) -> None:
        self._kill()

    def wait_for(self, condition: Callable[[], Any], seconds: float = 120.0) -> Any:
        """Wait until a condition holds or the command has ended; returns what the condition gave."""
        deadline = time.monotonic() + seconds
        while not (found := condition()) and self.process.poll() is None and time.monotonic() < deadline:
            time.sleep(_LOOK_INTERVAL)
        return found

    def has_driven(self, seconds: float) -> bool:
        """Whether the record of a run has got that far, s simulated."""
        for record in self.results.glob("*/log/record.csv"):
            lines = record.read_text(encoding="utf-8").splitlines()
            if len(lines) > 2 and float(lines[-2].partition(",")[0]) >= seconds:
                return True
        return False

    def members(self) -> list[psutil.Process]:
        """All of its processes that run."""
        return processes_with(_MARK, self._mark)

    def node(self, name: str) -> Optional[psutil.Process]:
        """The process of a node, as in `robot1/move_base`; nothing if it does not run."""
        return next((each for each in self.members() if self.name_of(each) == name), None)

    def name_of(self, process: psutil.Process) -> str:
        """The name of a node, or `roslaunch`, `master`, `runner`; empty for helpers of those."""
        try:
            words = process.cmdline()
            namespace = process.environ().get("ROS_NAMESPACE", "").strip("/")
        except psutil.Error:
            return ""
        names = [word.partition(":=")[2] for word in words if word.startswith("__name:=")]
        if names:
            return "/".join(filter(None, [namespace, *names]))
        known = {"roslaunch": "roslaunch", "f1tenth_scenarios.launch.private_master": "master"}
        for word in words[:4]:
            if Path(word).name in known:
                return known[Path(word).name]
        return RUNNER if process.pid == self.process.pid else ""

    def end(self, patience: float) -> Ending:
        """Wait until none of its processes runs; those left after `patience` (wall s) are killed."""
        begun, judged = time.monotonic(), None
        while self.members() and time.monotonic() - begun < patience:
            if judged is None and self._has_verdict():
                judged = time.monotonic()
            self.process.poll()
            time.sleep(_LOOK_INTERVAL)
        ended, code = time.monotonic(), self._exit_code()
        self._kill()
        with self._output as output:
            output.seek(0)
            said = output.read()
        found = [*self.results.glob("*/result.json"), *self.results.glob("*/interrupted/result.json")]
        result = json.loads(found[0].read_text(encoding="utf-8")) if found else None
        after = ended - (judged or begun)
        return Ending(code, ended - begun, after, result, any(self.results.rglob("junit.xml")), said)

    def _has_verdict(self) -> bool:
        """Whether it has written one, as it sees its files: it may have its own disk."""
        seen = Path(f"/proc/{self.process.pid}/root{self.written}")
        with contextlib.suppress(OSError):
            return any(seen.glob("*/result.json")) or any(seen.glob("*/interrupted/result.json"))
        return False

    def _exit_code(self) -> Optional[int]:
        # A process that is ending has lost its environment a moment before it is gone.
        with contextlib.suppress(subprocess.TimeoutExpired):
            return self.process.wait(1.0)
        return None

    def _kill(self) -> None:
        for other in self.beside:
            other.kill()
            other.wait()
        # A signal takes time to arrive, and a process that starts meanwhile has not got it.
        deadline = time.monotonic() + _KILL_PATIENCE
        while (left := self.members()) and time.monotonic() < deadline:
            for each in left:
                with contextlib.suppress(psutil.NoSuchProcess):
                    each.kill()
            psutil.wait_procs(left, timeout=_LOOK_INTERVAL)
        self.process.wait()
