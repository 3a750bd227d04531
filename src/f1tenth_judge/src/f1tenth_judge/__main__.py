"""python3 -m f1tenth_judge: the command `f1tenth`."""

import signal
import sys
from typing import NoReturn


def command() -> NoReturn:
    """Run the command with the arguments of this process, and end it."""
    # Until there is something to end in order, Ctrl-C ends this process at once, without a word.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    from f1tenth_judge.cli import main
    from f1tenth_judge.cli.exit_codes import leave

    leave(main(sys.argv[1:], "f1tenth"))


if __name__ == "__main__":
    command()
