"""What records and shows episodes: f1tenth_judge, which builds on this package and is imported by name."""

import importlib
from os import PathLike

RECORDER, WATCH = "f1tenth_judge.report.episodes", "f1tenth_judge.report.live.episodes"


def recorder_into(folder, stage):
    """The Recorder of a stage's episodes into a folder; None if there is no folder.

    Raises:
        ValueError: not a path; f1tenth_judge, which has the report, cannot be imported; the folder has
            episodes.
        OSError: the folder cannot be made.
    """
    if folder is None:
        return None
    if not isinstance(folder, (str, PathLike)):
        raise ValueError(f"record: found {folder!r}, allowed is the path of a folder")
    return _module("record", RECORDER).Recorder(folder, stage)


def watch_of(wanted, stage):
    """What shows a stage's episodes in a browser, if that is wanted; None if not.

    Raises:
        ValueError: f1tenth_judge, which has the page, cannot be imported.
    """
    return _module("watch", WATCH).Watch(stage) if wanted else None


def _module(option, name):
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ValueError(f"{option}: {error}; the report is a part of f1tenth_judge") from error
