"""What commands are told to write."""

import argparse
from pathlib import Path


def named_path(text):
    """The path that an option of argparse names, whose name is that of files to write.

    Raises:
        argparse.ArgumentTypeError: it has no name, as `.` and `..`.
    """
    path = Path(text)
    if path.name in ("", ".."):
        raise argparse.ArgumentTypeError(f"found {text!r}, must end with a name")
    return path
