"""What tests in a browser share."""

import pytest
from browser import chromium


@pytest.fixture(scope="module")
def window():
    """A browser for the tests of a file."""
    with chromium() as made:
        yield made
