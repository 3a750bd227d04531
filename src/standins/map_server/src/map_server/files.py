"""Writes files so that nobody ever finds a partial one."""

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
            with _naming(path):
                _check_replaceable(path)
                _write(temporary[path], content)
        for path in contents:
            with _naming(path):
                os.replace(temporary[path], path)
    finally:
        for path in temporary.values():
            with contextlib.suppress(OSError):
                path.unlink()


@contextlib.contextmanager
def _naming(path):
    try:
        yield
    except OSError as error:
        raise MapSaveError(f"{path}: cannot be written: {error.strerror}") from error


def _check_replaceable(path):
    # Renaming would replace a read-only file as well, and fail for a folder only half-way.
    if path.exists():
        with path.open("ab"):
            pass


def _write(path, content):
    with path.open("xb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
