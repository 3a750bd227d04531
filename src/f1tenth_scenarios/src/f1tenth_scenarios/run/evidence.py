"""Noticing that the files which a verdict rests on are not what the simulator wrote any more."""

import hashlib
import os
from pathlib import Path
from typing import Optional

from f1tenth_judge.record.files import reading
from f1tenth_judge.record.record import first_record


class Evidence:
    """Follows files that only grow while a run goes on."""

    def __init__(self, *paths: Path):
        self._files = [_GrowingFile(path) for path in paths]

    def problem(self) -> str:
        """What somebody did to one of the files, in words; empty if nothing. Cheap: reads what is new."""
        return next(filter(None, (each.follow() for each in self._files)), "")

    def problem_at_end(self) -> str:
        """The same, when nobody writes any more: whether all that was once there still is."""
        return next(filter(None, (each.follow() or each.verify() for each in self._files)), "")


class _GrowingFile:
    def __init__(self, path: Path):
        self._path = path
        self._inode: Optional[int] = None
        self._size = 0
        self._digest = hashlib.sha256()

    def follow(self) -> str:
        """Take what is new; or what is wrong."""
        try:
            # The simulator itself begins its record anew after a reset, and keeps the one before.
            with reading(first_record(self._path)) as stream:
                return self._take(stream, os.fstat(stream.fileno()))
        except OSError:
            return "" if self._inode is None else self._was("removed")

    def verify(self) -> str:
        """Whether what has been taken still stands in the file."""
        if self._inode is None:
            return ""
        with reading(first_record(self._path)) as stream:
            same = hashlib.sha256(stream.read(self._size)).digest() == self._digest.digest()
        return "" if same else self._was("overwritten")

    def _take(self, stream, status: os.stat_result) -> str:
        if self._inode not in (None, status.st_ino):
            return self._was("replaced")
        if status.st_size < self._size:
            return self._was("cut short")
        self._inode = status.st_ino
        stream.seek(self._size)
        data = stream.read()
        self._digest.update(data)
        self._size += len(data)
        return ""

    def _was(self, what: str) -> str:
        return f"{self._path} was {what} while the run went on"
