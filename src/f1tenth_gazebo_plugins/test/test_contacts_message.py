import io

import rospy
from f1tenth_gazebo_plugins.contacts_message import ContactsBytes, read_contacts
from gazebo_msgs.msg import ContactsState, ContactState


def on_the_wire(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def message(*pairs):
    result = ContactsState(states=[ContactState(collision1_name=a, collision2_name=b) for a, b in pairs])
    result.header.stamp = rospy.Time(12, 345_000_000)
    result.header.frame_id = "map"
    return result


def test_reads_stamp_of_a_message_without_contacts():
    assert read_contacts(on_the_wire(message())) == (12_345_000_000, ())


def test_reads_names_of_contacts():
    pairs = [("robot1::a::b", "walls::c::d"), ("robot1::a::b", "box::e::f")]
    assert read_contacts(on_the_wire(message(*pairs))) == (12_345_000_000, pairs)


def test_bytes_have_the_type_of_the_message_and_stay_as_they_are():
    assert ContactsBytes._type == ContactsState._type
    assert ContactsBytes._md5sum == ContactsState._md5sum
    assert ContactsBytes().deserialize(b"abc").data == b"abc"
