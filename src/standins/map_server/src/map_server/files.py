"""Writes files so that nobody ever finds half of one."""

import contextlib
import os

from map_server.errors import MapSaveError


def replace_files(contents):
    """Write `contents` (path -> bytes): each to a temporary file beside its place, then all are renamed.

    Whatever goes wrong while writing, the old files stay and no new one is left behind.
    Raises MapSaveError naming the file.
    """
    temporary = {path: path.with_name(f".{path.name}.{os.getpid()}.tmp") for path in contents}
    try:
        for path, content in contents.items():
            _guard(path, _check_replaceable)
            _guard(path, lambda _, place=temporary[path], data=content: _write(place, data))
        for path in contents:
            _guard(path, lambda place, source=temporary[path]: os.replace(source, place))
    finally:
        for path in temporary.values():
            with contextlib.suppress(OSError):
                path.unlink()


def _guard(path, action):
    try:
        action(path)
    except OSError as error:
        raise MapSaveError(f"{path}: cannot be written: {error.strerror}") from error


def _check_replaceable(path):
    # Renaming would replace a read-only file as well, and fail for a folder only half-way.
    if path.exists():
        with path.open("ab"):
            pass


def _write(path, content):
    with open(path, "xb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
