"""What records episodes: f1tenth_judge, which builds on this package and is imported by name."""

import importlib
from os import PathLike

RECORDER = "f1tenth_judge.report.episodes"


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
    try:
        module = importlib.import_module(RECORDER)
    except ImportError as error:
        raise ValueError(f"record: {error}; the report is a part of f1tenth_judge") from error
    return module.Recorder(folder, stage)
