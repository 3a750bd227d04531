"""Files that are either complete or not there."""

import contextlib
import os
import uuid
from collections.abc import Iterator, Mapping
from pathlib import Path


@contextlib.contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Give a temporary file beside `path`, which replaces it when the block ends without exception.

    Raises:
        OSError: it cannot be written; names `path`.
    """
    # A name that nobody knows beforehand, and could put a link or a pipe there.
    temporary = path.with_name(f".{path.name}.{uuid.uuid4().hex}{path.suffix}")
    try:
        yield temporary
        os.replace(temporary, path)
    except OSError as error:
        # A full disk is an error without a name.
        if error.filename in (None, str(temporary)):
            raise OSError(error.errno, error.strerror, str(path)) from error
        raise
    finally:
        with contextlib.suppress(OSError):
            temporary.unlink(missing_ok=True)


def write_all(content: Mapping[Path, bytes]) -> None:
    """Write files that belong together: all of them, or none.

    Raises:
        OSError: one cannot be written; names it.
    """
    with contextlib.ExitStack() as files:
        for path, data in content.items():
            files.enter_context(replacing(path)).write_bytes(data)
