"""What `ros2 launch` tells of the processes that it starts: their output and their ends."""

import re
from collections.abc import Sequence

from f1tenth_judge.run.log_excerpt import TRACEBACK

_SAYS = re.compile(r"\[([^\]\s]+-\d+)\](?: (.*))?$")  # who, and what
_DIED = re.compile(r"\[ERROR\] \[([^\]]+)\]: process has died \[pid \d+, exit code (-?\d+)")


def output_of_raiser(lines: Sequence[str]) -> list[str]:
    """What the process that raised last has said, as it said it, and `ros2 launch` itself; else all lines."""
    said = [(line, _SAYS.match(line)) for line in lines]
    raisers = [words[1] for _, words in said if words and (words[2] or "").startswith(TRACEBACK)]
    if not raisers:
        return list(lines)
    own = (words[2] if words else line for line, words in said if not words or words[1] == raisers[-1])
    return [line for line in own if line]


def dead_processes(lines: Sequence[str]) -> list[str]:
    """Those that ended with an error, in words: `ros2 launch` goes on, or itself ends with exit code 0."""
    return [f"{died[1]} died with exit code {died[2]}" for died in map(_DIED.match, lines) if died]
