"""The roslaunch that has started a node."""

import os
import signal


def end_launch() -> None:
    """Interrupt it, as Ctrl-C does: it takes the end of a required node for an accident, and says so in red.

    It ends this process as well, but not before this returns.
    """
    os.kill(os.getppid(), signal.SIGINT)
