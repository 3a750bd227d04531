"""The stand-in's messages and services must be the original's on the wire."""

import pytest
from gazebo_msgs import msg, srv

# Read off the original package (gazebo_msgs 2.9.2).
MESSAGE_MD5_SUMS = {
    "ContactState": "48c0ffb054b8c444f870cecea1ee50d9",
    "ContactsState": "acbcb1601a8e525bf72509f18e6f668d",
    "LinkState": "0818ebbf28ce3a08d48ab1eaa7309ebe",
    "LinkStates": "48c080191eb15c41858319b4d8a609c2",
    "ModelState": "9330fd35f2fcd82d457e54bd54e10593",
    "ModelStates": "48c080191eb15c41858319b4d8a609c2",
}
SERVICE_MD5_SUMS = {
    "DeleteModel": "9ce56b4e9e54616de25d796dc972a262",
    "GetLinkState": "09d6c98cce97b35f7ab9bd70300657ab",
    "GetModelProperties": "5717f7bd34ed990fa80e28b3015027a3",
    "GetModelState": "4c515e936d3319c9610c559c60bfc3d4",
    "GetPhysicsProperties": "575a5e74786981b7df2e3afc567693a6",
    "GetWorldProperties": "36bb0f2eccf4d8be971410c22818ba3f",
    "SetModelState": "5b3ab0281d4f5445def017e3a2e4a07b",
    "SetPhysicsProperties": "97e2057080558ce4730434b5fae75c91",
    "SpawnModel": "9ed9c82c96abe1a00c3e8cdaeee24413",
}


@pytest.mark.parametrize("name", sorted(MESSAGE_MD5_SUMS))
def test_message_has_the_md5_sum_of_the_original(name):
    assert getattr(msg, name)._md5sum == MESSAGE_MD5_SUMS[name]


@pytest.mark.parametrize("name", sorted(SERVICE_MD5_SUMS))
def test_service_has_the_md5_sum_of_the_original(name):
    assert getattr(srv, name)._md5sum == SERVICE_MD5_SUMS[name]
