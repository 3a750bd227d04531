"""What planners on Fast DDS keep in shared memory, and leave there when they are killed."""

import contextlib
import fcntl
from pathlib import Path

_SHARED_MEMORY = Path("/dev/shm")
_LOCKS = "fast*_[es]l"  # beside the file that they guard; whoever has made that holds the lock while it lives


def remove_what_is_left(since: float, folder: Path = _SHARED_MEMORY) -> None:
    """Remove the files of processes that are gone, as `fastdds shm clean` does; none from before (Unix s)."""
    for lock in folder.glob(_LOCKS):
        with contextlib.suppress(OSError), lock.open() as file:
            if lock.stat().st_mtime >= since:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                guarded = lock.name[:-3]
                for name in (guarded, f"sem.{guarded}_mutex", lock.name):
                    (folder / name).unlink(missing_ok=True)
