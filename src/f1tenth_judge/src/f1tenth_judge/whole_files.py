"""Files that belong together: all of them are written, or none is."""

import contextlib
import os


def write_all(content):
    """Write the bytes of each path; first beside their places, as the disk may be full.

    Raises:
        OSError: if a file cannot be written; names it.
    """
    temporary = {path: path.with_name(f".{path.name}.{os.getpid()}") for path in content}
    try:
        for path, data in content.items():
            with _naming(path):
                temporary[path].write_bytes(data)
        for path, other in temporary.items():
            with _naming(path):
                os.replace(other, path)
    finally:
        for other in temporary.values():
            with contextlib.suppress(OSError):
                other.unlink(missing_ok=True)


@contextlib.contextmanager
def _naming(path):
    """A full disk is an error without a name, others name the temporary file."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error
