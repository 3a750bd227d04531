"""The part of a node's output that tells why it failed."""

import re
import textwrap
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Optional

from f1tenth_judge.record.files import reading

LINE_COUNT = 10  # at most, of what is quoted
TRACEBACK = "Traceback (most recent call last)"
_FRAME = '  File "'
# Installed packages, and Python's; but colcon installs a workspace of ROS 2 in its folder install.
_NOT_ITS_OWN = re.compile(r'  File "((?!/[^"]*/install/)[^"]*/lib/python3[.\d]*/|<frozen )')
_CHATTER = re.compile(r"\[(rospy\.[\w.]+|xmlrpc)\]\[INFO\] ")  # of rospy about itself
_EXCEPTION = re.compile(r"[A-Za-z_][\w.]*(: |:?$)")
_ESCAPE = re.compile(r"\x1b\[[0-9;]*m|\x1b\]2;[^\x07]*\x07")
_WIDTH = 200  # characters, of an exception


def plain(line: bytes) -> str:
    """The text without colours and other commands to a terminal."""
    return _ESCAPE.sub("", line.decode("utf-8", errors="replace")).rstrip()


def last_lines(path: Path, count: Optional[int] = None, until: Optional[int] = None) -> list[str]:
    """The last lines of a file that are not empty, else all; none when it cannot be read.

    `until`: bytes from the beginning, as far as it is read; default: all.
    """
    try:
        with reading(path) as stream:
            data = stream.read(-1 if until is None else until)
    except OSError:
        return []
    return [line for line in map(plain, data.splitlines()) if line][-(count or 0) :]


def quoted(lines: Sequence[str]) -> list[str]:
    """The last lines that tell something; the last traceback and what follows it, if there is one.

    Of a traceback, only the last frame of the node's own code and the exception are quoted.
    """
    telling = [line for line in lines if not _CHATTER.match(line)]
    begin, end = _place_of_last_traceback(telling)
    told = [*_shortened(telling[begin:end]), *telling[end:]][:LINE_COUNT]
    room = LINE_COUNT - len(told)
    return [*telling[max(0, begin - room) : begin], *told]


def last_traceback(lines: Sequence[str]) -> list[str]:
    """The last one in some lines, with the exception."""
    begin, end = _place_of_last_traceback(lines)
    return list(lines[begin:end])


def exception_in(lines: Sequence[str]) -> str:
    """What the last traceback in some lines ends with; empty if there is none."""
    traceback = last_traceback(lines)
    is_whole = traceback and _EXCEPTION.match(traceback[-1])
    return textwrap.shorten(traceback[-1], _WIDTH) if is_whole else ""


def _place_of_last_traceback(lines: Sequence[str]) -> tuple[int, int]:
    """From where to where it is, with the exception; an empty place at the end if there is none."""
    begins = [number for number, line in enumerate(lines) if line.startswith(TRACEBACK)]
    # A script that cannot be parsed has nothing but the place: no call has led there.
    begins = begins or [number for number, line in enumerate(lines) if line.startswith(_FRAME)][:1]
    if not begins:
        return len(lines), len(lines)
    after = range(begins[-1] + 1, len(lines))
    end = next((number + 1 for number in after if not lines[number].startswith(" ")), len(lines))
    return begins[-1], end


def _shortened(traceback: Sequence[str]) -> list[str]:
    frames = list(_frames(traceback[1:]))
    own = [frame for frame in frames if not _NOT_ITS_OWN.match(frame[0])] or frames
    return [*traceback[:1], *own[-1], *traceback[-1:]] if own else list(traceback)


def _frames(traceback: Sequence[str]) -> Iterator[Sequence[str]]:
    begins = [number for number, line in enumerate(traceback) if line.startswith(_FRAME)]
    for begin, end in zip(begins, [*begins[1:], len(traceback) - 1]):
        yield traceback[begin:end]
