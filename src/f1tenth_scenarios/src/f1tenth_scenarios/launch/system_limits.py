"""Limits of the operating system that hinder a run."""

import resource
from collections.abc import Mapping
from typing import Optional

import psutil
from f1tenth_judge.errors import ScenarioError

# roscpp refuses connections when fewer are free (XmlRpcServer::FREE_FD_BUFFER), without a word.
_FREE_DESCRIPTORS = 32
_LEAST_MEMORY = 10**9  # bytes of address space, which drawing the picture takes


def require_memory() -> None:
    """Refuse to begin what would end in many processes that each complain in their own way.

    Raises:
        ScenarioError: processes may have too little memory.
    """
    limit = resource.getrlimit(resource.RLIMIT_AS)[0]
    if limit not in (resource.RLIM_INFINITY, -1) and limit < _LEAST_MEMORY:
        raise ScenarioError(
            f"ulimit -v lets a process have {limit / 1e6:.0f} MB of memory, a run needs"
            f" {_LEAST_MEMORY / 1e6:.0f} MB"
        )


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
