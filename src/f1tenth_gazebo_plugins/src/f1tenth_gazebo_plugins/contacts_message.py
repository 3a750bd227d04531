"""Reads gazebo_msgs/ContactsState cheaply: most messages carry no contact; that is seen without decoding."""

import struct

from gazebo_msgs.msg import ContactsState

# Header: seq, stamp (secs, nsecs), length of frame_id; then frame_id, then the number of states.
_HEADER = struct.Struct("<IIII")
_COUNT = struct.Struct("<I")


class ContactsBytes(ContactsState):
    """A ContactsState on the wire, with its type and MD5 sum, that stays in bytes when it is received."""

    def __init__(self):  # The message's fields are never used: not making them is most of what is saved.
        self.data = b""

    def deserialize(self, data):
        """Keep the bytes."""
        self.data = data
        return self


def read_contacts(data):
    """Return the stamp in ns and, for each contact, the scoped names of the two collision elements."""
    _, secs, nsecs, frame_id_length = _HEADER.unpack_from(data)
    (count,) = _COUNT.unpack_from(data, _HEADER.size + frame_id_length)
    stamp = secs * 1_000_000_000 + nsecs
    if count == 0:
        return stamp, ()
    states = ContactsState().deserialize(data).states
    return stamp, [(state.collision1_name, state.collision2_name) for state in states]
