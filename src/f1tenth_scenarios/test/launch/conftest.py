"""A bag, written by hand."""

import pytest
import rosbag
import rospy


@pytest.fixture
def bag(tmp_path):
    """Gives a function that writes messages: topic, when they were heard (s), message; of a node."""

    def write(*messages, node="/robot1/planner"):
        with rosbag.Bag(str(tmp_path / "run.bag"), "w") as opened:
            for topic, heard, message in messages:
                header = {
                    "callerid": node,
                    "topic": topic,
                    "type": message._type,
                    "md5sum": message._md5sum,
                    "message_definition": message._full_text,
                }
                opened.write(topic, message, rospy.Time.from_sec(heard), connection_header=header)
        return tmp_path / "run.bag"

    return write
