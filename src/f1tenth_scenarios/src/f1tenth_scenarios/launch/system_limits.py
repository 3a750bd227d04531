"""Limits of the operating system that hinder a run."""

from collections.abc import Mapping
from typing import Optional

import psutil

# roscpp refuses connections when fewer are free (XmlRpcServer::FREE_FD_BUFFER), without a word.
_FREE_DESCRIPTORS = 32


def hindered(processes: Mapping[str, int]) -> Optional[tuple[str, str]]:
    """The first of some processes (their ids by name) that is there and cannot go on, and why."""
    found = ((name, _hindrance(pid)) for name, pid in processes.items())
    return next(((name, reason) for name, reason in found if reason), None)


def _hindrance(pid: int) -> str:
    try:
        process = psutil.Process(pid)
        if process.status() == psutil.STATUS_STOPPED:
            return "is stopped by a signal (SIGSTOP, or Ctrl-Z)"
        count, most = process.num_fds(), process.rlimit(psutil.RLIMIT_NOFILE)[0]
    except psutil.Error:
        return ""
    if 0 <= most <= count + _FREE_DESCRIPTORS:
        return f"Too many open files: {count} of the {most} that it may have (ulimit -n)"
    return ""
