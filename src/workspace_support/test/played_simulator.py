"""Plays the simulator of lockstep: goes on when the node has answered."""

import threading

import rospy
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage

PATIENCE = 60.0  # s of wall time
REPEAT = 0.5  # s of wall time


class Simulator:
    """Publishes periods, which one node on a lidar answers, and hears its transforms from the map.

    Args:
        mounting: where the lidar is on the car, a TFMessage
    """

    def __init__(self, mounting):
        self._mounting = mounting
        self._answered = threading.Condition()
        self._done = rospy.Time()
        self._transforms = []
        kinds = {"/tf": TFMessage, "/scan": LaserScan}
        self._publishers = {topic: self._publisher(topic, kind) for topic, kind in kinds.items()}
        self._static = rospy.Publisher("/tf_static", TFMessage, queue_size=None, latch=True)
        self._clock = self._publisher("/clock", Clock)
        rospy.Subscriber("/sim2d/done", Header, self._on_done)
        self._listener = rospy.Subscriber("/tf", TFMessage, self._on_transforms)

    @staticmethod
    def _publisher(topic, kind):
        # Without a queue the message is in the socket when publish() returns.
        return rospy.Publisher(topic, kind, queue_size=None, tcp_nodelay=True)

    def _on_done(self, message):
        with self._answered:
            self._done = message.stamp
            self._answered.notify_all()

    def _on_transforms(self, message):
        with self._answered:
            self._transforms += [t for t in message.transforms if t.header.frame_id == "map"]
            self._answered.notify_all()

    def transforms_until(self, stamp):
        """The transforms from the map up to the one of a stamp, in order."""
        with self._answered:
            assert self._answered.wait_for(
                lambda: self._transforms and self._transforms[-1].header.stamp >= stamp, PATIENCE
            )
            return [t for t in self._transforms if t.header.stamp <= stamp]

    def wait_for_listeners(self):
        """Until the node hears everything and is heard, too."""
        publishers = [*self._publishers.values(), self._clock]
        while not all(p.get_num_connections() for p in publishers) or not self._hears_node():
            threading.Event().wait(0.01)

    def _hears_node(self):
        return self._listener.get_num_connections() > 1  # one is this node's own

    def run(self, periods):
        """Publish each period and wait for the answer.

        Args:
            periods: of each, the stamp and what is sent: pairs of topic, /tf or /scan, and message
        """
        self._static.publish(self._mounting)
        for stamp, messages in periods:
            for topic, message in messages:
                self._publishers[topic].publish(message)
            self._wait_for_answer(stamp)

    def call(self, service, stamps):
        """Call a service, which is served between periods; nothing else happens in them.

        Args:
            service: is called without arguments
            stamps: of the periods, as many as it takes

        Returns:
            its answer
        """
        answers = []
        thread = threading.Thread(target=lambda: answers.append(service()), daemon=True)
        thread.start()
        while thread.is_alive():
            self.run([(next(stamps), [])])
            thread.join(0.005)
        return answers[0]

    def _wait_for_answer(self, stamp):
        # The first clock may come before the participant listens: as the simulator does, it is said again.
        for _ in range(round(PATIENCE / REPEAT)):
            self._clock.publish(stamp)
            with self._answered:
                if self._answered.wait_for(lambda: self._done == stamp, REPEAT):
                    return
        raise AssertionError(f"no answer at {stamp}")
