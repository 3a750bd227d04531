"""The memory that a run needs."""

import resource

from f1tenth_judge.errors import ScenarioError

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
