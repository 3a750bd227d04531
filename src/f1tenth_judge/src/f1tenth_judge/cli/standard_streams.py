"""Standard streams that whoever started this process has closed."""

import os
import sys

_STREAMS = (("stdin", "r"), ("stdout", "w"), ("stderr", "w"))  # by their file descriptors


def open_standard_streams() -> None:
    """Let those that are closed lead nowhere: else files opened later would take their places.

    Programs that are started would then write into these files what they print.
    """
    for number, (name, mode) in enumerate(_STREAMS):
        if getattr(sys, name) is None:
            _open_if_closed(number)
            setattr(sys, name, os.fdopen(number, mode, encoding="utf-8", closefd=False))


def _open_if_closed(number: int) -> None:
    try:
        os.fstat(number)
    except OSError:
        nowhere = os.open(os.devnull, os.O_RDWR)
        if nowhere != number:
            os.dup2(nowhere, number)
            os.close(nowhere)
        os.set_inheritable(number, True)
