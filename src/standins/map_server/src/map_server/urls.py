"""Where a map_url of nav_msgs/LoadMap points to."""

from pathlib import Path
from urllib.parse import unquote, urlsplit

import rospkg

from map_server.errors import MapNotFoundError


def path_of(url):
    """Return the file of a plain path, file:///PATH or package://PACKAGE/PATH.

    Raises MapNotFoundError.
    """
    try:
        parts = urlsplit(url)
    except ValueError as error:
        raise MapNotFoundError(f"{url}: not a URL: {error}") from error
    if not parts.scheme:
        return Path(url)
    if parts.scheme == "file" and not parts.netloc:
        return Path(unquote(parts.path))
    if parts.scheme != "package" or not parts.netloc:
        raise MapNotFoundError(f"{url}: allowed are a path, file:///PATH and package://PACKAGE/PATH")
    try:
        return Path(rospkg.RosPack().get_path(parts.netloc)) / unquote(parts.path).lstrip("/")
    except rospkg.ResourceNotFound as error:
        raise MapNotFoundError(f"{url}: there is no package {parts.netloc}") from error
