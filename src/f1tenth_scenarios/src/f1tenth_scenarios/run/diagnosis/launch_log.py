"""What roslaunch says about the processes it started."""

import dataclasses
import re
from pathlib import Path
from typing import Any, Optional

from f1tenth_scenarios.run.file_tail import LineTail

_CODE = r"exit code (?P<code>-?\d+)(, cmd \S*?(?P<package>[^/ ]+)/[^/ ]+[ \]])?"
_DIED = re.compile(rf"\[(?P<process>\S+)\] process has died \[pid (?P<pid>-?\d+), {_CODE}")
_REQUIRED = re.compile(r"REQUIRED process \[(?P<process>\S+)\] has died")
_REQUIRED_END = re.compile(rf"process has (died \[pid -?\d+, {_CODE}|finished cleanly)")
_FINISHED = re.compile(r"\[(?P<process>\S+)\] process has finished cleanly")
_STARTED = re.compile(r"process\[(?P<process>\S+)\]: started with pid \[(?P<pid>\d+)\]")
_REFUSED = re.compile(r"ERROR: cannot launch node of type \[(?P<type>[^]]+)\]: (?P<reason>.*)")
_FOR_PEOPLE = (
    "image_view",
    "joy",
    "joy_teleop",
    "plotjuggler",
    "rviz",
    "teleop_twist_joy",
    "teleop_twist_keyboard",
)
_LOG_FILE = re.compile(r"^log file: (?P<pattern>.*)\*\.log")


@dataclasses.dataclass(frozen=True)
class NodeEnd:
    """A node that ended while roslaunch was not ending it, or could not be started at all."""

    node: str  # name without the leading slash; PACKAGE/TYPE of one that could not be started
    exit_code: int
    log_file: Optional[str] = None
    refusal: str = ""  # why it could not be started
    package: str = ""  # that its executable is from; empty if it is not known
    is_required: bool = False  # whether roslaunch ends with it

    @property
    def is_for_people(self) -> bool:
        """Whether it only shows something, or passes on what a person's hands do."""
        return self.package in _FOR_PEOPLE or self.package.startswith("rqt")

    def describe(self) -> str:
        """How it ended, in words."""
        if self.refusal:
            return f"cannot be started: {self.refusal}"
        if self.exit_code < 0:
            return f"was killed by signal {-self.exit_code}"
        how = f"ended with exit code {self.exit_code}"
        return f'{how}, and is required="true" in its launch file' if self.is_required else how


class LaunchLog:
    """Follows roslaunch's output."""

    def __init__(self, path: Path):
        self._tail = LineTail(path)
        self._required: Optional[str] = None
        self.ends: list[NodeEnd] = []
        self.pids: dict[str, int] = {}  # by node

    def poll(self) -> None:
        """Read what has been added."""
        for line in self._tail.new_lines():
            self._take(line)

    def _take(self, line: str) -> None:
        log_file = _LOG_FILE.match(line)
        if log_file and self.ends:
            self.ends[-1] = dataclasses.replace(self.ends[-1], log_file=f"{log_file['pattern']}*.log")
        elif found := _STARTED.search(line):
            self.pids[_node(found["process"])] = int(found["pid"])
        elif found := _REFUSED.search(line):
            self._refuse(found["type"], found["reason"])
        elif found := _REQUIRED.search(line):
            self._required = found["process"]
        elif found := _DIED.search(line):
            self._add(found["process"], int(found["code"]), package=found["package"] or "")
        elif found := _FINISHED.search(line):
            self._add(found["process"], 0)
        elif self._required and (found := _REQUIRED_END.search(line)):
            code, package = int(found["code"] or 0), found["package"] or ""
            self._add(self._required, code, package=package, is_required=True)
            self._required = None

    def _add(self, process: str, exit_code: int, **more: Any) -> None:
        self.ends.append(NodeEnd(_node(process), exit_code, **more))

    def _refuse(self, kind: str, reason: str) -> None:
        package = kind.partition("/")[0]
        # Of a package that it does not find, roslaunch says the name alone.
        why = f"there is no package {package}" if reason == package else reason
        self.ends.append(NodeEnd(kind, 1, refusal=why, package=package))


def _node(process: str) -> str:
    # roslaunch appends "-3" to the name of the third process.
    return process.rpartition("-")[0]
