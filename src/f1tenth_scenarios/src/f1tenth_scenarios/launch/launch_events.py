"""What becomes of the nodes that a launcher starts."""

import contextlib
import dataclasses
import json
import os
from collections.abc import Mapping
from typing import Any, Optional

PIPE = "F1TENTH_LAUNCH_EVENTS"  # environment variable of the launcher: the file descriptor
_BUFFER = 1 << 16  # bytes
_FOR_PEOPLE = (
    "image_view",
    "joy",
    "joy_teleop",
    "plotjuggler",
    "rviz",
    "teleop_twist_joy",
    "teleop_twist_keyboard",
)


@dataclasses.dataclass(frozen=True)
class NodeEnd:
    """A node that ended while its launcher was not ending it, or could not be started at all."""

    node: str  # name without the leading slash; PACKAGE/TYPE of one that could not be started
    exit_code: int
    log_file: Optional[str] = None  # pattern of its own log files
    refusal: str = ""  # why it could not be started
    package: str = ""  # that its executable is from; empty if it is not known
    is_required: bool = False  # whether all others end with it
    said: Optional[int] = None  # bytes that were in the common log by then

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


class LaunchEvents:
    """Follows a launcher, which writes into `pipe`; to be closed at the end."""

    def __init__(self):
        self._reading, self.pipe = os.pipe()
        os.set_blocking(self._reading, False)
        self._rest = b""
        self.ends: list[NodeEnd] = []
        self.pids: dict[str, int] = {}  # by node

    @property
    def variables(self) -> dict[str, str]:
        """Of the launcher's environment."""
        return {PIPE: str(self.pipe)}

    def poll(self) -> None:
        """Take what has been told since the last call."""
        with contextlib.suppress(BlockingIOError):
            while data := os.read(self._reading, _BUFFER):
                *lines, self._rest = (self._rest + data).split(b"\n")
                for line in lines:
                    self._take(json.loads(line))

    def close(self) -> None:
        """Stop listening."""
        os.close(self.pipe)
        os.close(self._reading)

    def _take(self, told: Mapping[str, Any]) -> None:
        if told["event"] == "started":
            self.pids[_node(told["process"])] = told["pid"]
        elif told["event"] == "refused":
            self.ends.append(_refusal(told["package"], told["type"], told["reason"]))
        else:
            self.ends.append(_end(**told))


def _refusal(package: str, kind: str, reason: str) -> NodeEnd:
    first = reason.partition("\n")[0]
    # Of a package that it does not find, roslaunch says the name alone.
    why = f"there is no package {package}" if first == package else first
    return NodeEnd(f"{package}/{kind}", 1, refusal=why, package=package)


def _end(process: str, exit_code: Optional[int], event: str, **others: Any) -> NodeEnd:
    return NodeEnd(_node(process), 1 if exit_code is None else exit_code, **others)


def _node(process: str) -> str:
    # roslaunch appends "-3" to the name of the third process.
    return process.rpartition("-")[0]
