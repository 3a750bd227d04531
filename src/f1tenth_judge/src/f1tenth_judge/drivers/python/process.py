"""The process of a planner: python3 -m f1tenth_judge.drivers.python.process FILE:CLASS."""

import importlib.util
import os
import struct
import sys
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

PIPE = "F1TENTH_PLANNER_PIPE"  # environment variable: the file descriptor
ANSWER = struct.Struct("ff")  # speed (m/s) and steering angle (rad), as an AckermannDrive has them
READY = b"ready"
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
        if hasattr(planner, "reset"):
            planner.reset(info)
        pipe.send_bytes(READY)
        while True:
            try:
                observation = pipe.recv()
            except EOFError:
                return
            pipe.send_bytes(answer_of(planner.plan(observation)))


if __name__ == "__main__":
    main()
