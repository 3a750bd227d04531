"""The stand-in's messages must be the original's on the wire."""

import pytest
from ackermann_msgs import msg

# Read off the original package (ackermann_msgs 1.0.2).
MD5_SUMS = {
    "AckermannDrive": "3512e91b48d69674a0e86fadf1ea8231",
    "AckermannDriveStamped": "1fd5d7f58889cefd44d29f6653240d0c",
}


@pytest.mark.parametrize("name", sorted(MD5_SUMS))
def test_message_has_the_md5_sum_of_the_original(name):
    assert getattr(msg, name)._md5sum == MD5_SUMS[name]
