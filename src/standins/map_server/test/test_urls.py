import re
from pathlib import Path

import pytest
from map_server.errors import MapNotFoundError
from map_server.urls import path_of

PACKAGE = Path(__file__).resolve().parents[1]


@pytest.mark.parametrize(
    ("url", "path"),
    [
        ("/a/b.yaml", "/a/b.yaml"),
        ("b.yaml", "b.yaml"),
        ("file:///a/b%20c.yaml", "/a/b c.yaml"),
        ("package://map_server/floor/b.yaml", PACKAGE / "floor/b.yaml"),
    ],
)
def test_url_means_a_path(url, path):
    assert path_of(url).resolve() == Path(path).resolve()


@pytest.mark.parametrize("url", ["http://host/b.yaml", "file://host/b.yaml", "package:///b.yaml"])
def test_other_urls_are_refused(url):
    with pytest.raises(MapNotFoundError) as raised:
        path_of(url)
    assert str(raised.value) == f"{url}: allowed are a path, file:///PATH and package://PACKAGE/PATH"


def test_what_is_no_url_is_refused():
    with pytest.raises(MapNotFoundError, match=re.escape("http://[x: not a URL: Invalid IPv6 URL")):
        path_of("http://[x")


def test_unknown_package_is_named():
    with pytest.raises(MapNotFoundError, match="package://none/b.yaml: there is no package none"):
        path_of("package://none/b.yaml")
