"""Files and folders that commands read and write: an error with them is one line."""

from pathlib import Path
from typing import Optional

from f1tenth_scenarios.atomic import replacing
from f1tenth_scenarios.errors import ScenarioError, writing


def made_folder(folder: Path) -> Path:
    """The folder, made if it is not there yet.

    Raises:
        ScenarioError: it cannot be made.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ScenarioError(f"{folder}: cannot be made: {error.strerror}") from error
    return folder


def expect_folder(folder: Optional[Path], option: str) -> None:
    """Refuse a wrong folder before the work whose outcome is to be written there, not after it.

    Raises:
        ScenarioError: the folder that an option names is not there.
    """
    if folder and not folder.is_dir():
        raise ScenarioError(f"{option} {folder}: there is no such folder")


def expect_folder_of(path: Optional[Path], option: str) -> None:
    """The same for a file that is to be written.

    Raises:
        ScenarioError: the folder of the path that an option names is not there.
    """
    if path and not path.resolve().parent.is_dir():
        raise ScenarioError(f"{option} {path}: there is no such folder")


def write_text(path: Path, text: str) -> None:
    """Write a file, whole or not at all.

    Raises:
        ScenarioError: it cannot be written.
    """
    with writing(path), replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
