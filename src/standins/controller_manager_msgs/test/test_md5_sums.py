"""The stand-in's messages and services must be the original's on the wire."""

import pytest
from controller_manager_msgs import srv

# Read off code generated from the original package. ListControllers holds both messages.
MD5_SUMS = {
    "ListControllers": "1341feb2e63fa791f855565d0da950d8",
    "ListControllerTypes": "c1d4cd11aefa9f97ba4aeb5b33987f4e",
    "LoadController": "647e5c54b8d6468952d8d31f1efe96c0",
    "SwitchController": "b29a7abc673b2c54c14b54e50f8d06a5",
    "UnloadController": "647e5c54b8d6468952d8d31f1efe96c0",
}


@pytest.mark.parametrize("name", sorted(MD5_SUMS))
def test_service_has_the_md5_sum_of_the_original(name):
    assert getattr(srv, name)._md5sum == MD5_SUMS[name]
