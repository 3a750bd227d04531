"""The process of a planner: python3 -m f1tenth_judge.drivers.python.process FILE:CLASS."""

import dataclasses
import importlib.util
import os
import struct
import sys
from collections.abc import Sequence
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from f1tenth_judge.drivers.python.pictures import PictureMemory
from f1tenth_judge.planner import Eye, Observation, Picture
from f1tenth_judge.said import notes

PIPE = "F1TENTH_PLANNER_PIPE"  # environment variable: the file descriptor
PICTURES = "F1TENTH_PLANNER_PICTURES"  # likewise, of the memory
LOOK = struct.Struct("B")  # asks for a picture: index of the eye
ANSWER = struct.Struct("ff")  # speed (m/s) and steering angle (rad), as an AckermannDrive has them
READY = b"ready"
NOTES = b"notes of a period: "  # longer than an answer; notes follow
_MODULE = "f1tenth_planner"  # by which name a file is imported


def load(text: str) -> Any:
    """Make the planner that FILE:CLASS names; the folder of the file is where it imports from."""
    name, _, kind = text.rpartition(":")
    file = Path(name).resolve()
    sys.path.insert(0, str(file.parent))
    spec = importlib.util.spec_from_file_location(_MODULE, file)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[_MODULE] = module
    spec.loader.exec_module(module)
    return getattr(module, kind)()


class Looks:
    """The pictures of one period, each asked for once."""

    def __init__(self, pipe: Connection, memory: PictureMemory, eyes: Sequence[Eye]):
        """Ask through the pipe."""
        self._pipe, self._memory, self._eyes = pipe, memory, eyes
        self._seen: dict[int, Picture] = {}
        self.is_over = False

    def draw(self, camera: str, name: str) -> Picture:
        """See Observation.look."""
        index = self._find(camera, name)
        if index not in self._seen:
            if self.is_over:
                raise LookupError(
                    "plan() has returned: the car does not see any more what this observation is of"
                )
            self._pipe.send_bytes(LOOK.pack(index))
            self._pipe.recv_bytes()
            self._seen[index] = self._memory.take(self._eyes[index])
        return self._seen[index]

    def _find(self, camera: str, name: str) -> int:
        for index, eye in enumerate(self._eyes):
            if camera in ("", eye.camera) and name in ("", eye.name):
                return index
        there = ", ".join(f"{eye.camera} {eye.name}" for eye in self._eyes) or "none"
        raise LookupError(f"the car has no camera {camera} {name}".rstrip() + f", there are: {there}")


def answer_of(command: Any) -> bytes:
    """What is sent for a command.

    Raises:
        TypeError: it is not two numbers.
    """
    try:
        speed, steering_angle = command
        return ANSWER.pack(speed, steering_angle)
    except (TypeError, ValueError, OverflowError, struct.error) as error:
        raise TypeError(f"plan() returned {command!r}, must be Command(speed, steering_angle)") from error


def main() -> None:
    """Answer each observation with a command until nobody asks any more."""
    planner = load(sys.argv[1])
    with Connection(int(os.environ[PIPE])) as pipe:
        info = pipe.recv()
        memory = PictureMemory(int(os.environ[PICTURES]), info["eyes"])
        if hasattr(planner, "reset"):
            planner.reset(info)
        pipe.send_bytes(READY)
        while True:
            try:
                observation: Observation = pipe.recv()
            except EOFError:
                return
            looks = Looks(pipe, memory, info["eyes"])
            answer = answer_of(planner.plan(dataclasses.replace(observation, draw=looks.draw)))
            looks.is_over = True
            if noted := getattr(planner, "notes", None):
                pipe.send_bytes(NOTES + notes.text_of(noted))
            pipe.send_bytes(answer)


if __name__ == "__main__":
    main()
