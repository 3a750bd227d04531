"""Names of the files that commands are told to write."""

import argparse
from pathlib import Path


def has_name(path):
    """Whether files can be named after it, unlike `.` and `..`."""
    return path.name not in ("", "..")


def named_path(text):
    """The path that an option of argparse names, whose name is that of files to write.

    Raises:
        argparse.ArgumentTypeError: it has no name.
    """
    path = Path(text)
    if not has_name(path):
        raise argparse.ArgumentTypeError(f"found {text!r}, must end with a name")
    return path
