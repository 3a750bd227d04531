#!/usr/bin/env python3
"""How the commands end when their controller manager ends, too."""

import signal
import threading
import unittest

import rospy
import rostest
from commands import LONG, run_until, start
from controller_manager_msgs.srv import LoadController, SwitchController, UnloadController


class EndingManager:
    """A controller manager of a namespace that fails to stop controllers, as one does that is ending.

    Args:
        time_left: wall s until its services are gone; None: they stay.

    """

    def __init__(self, namespace, time_left):
        self._time_left = time_left
        answers = {
            "load_controller": (LoadController, lambda request: True),
            "switch_controller": (SwitchController, self._switch),
            "unload_controller": (UnloadController, lambda request: True),
        }
        self._services = [
            rospy.Service(f"/{namespace}/controller_manager/{name}", kind, answer)
            for name, (kind, answer) in answers.items()
        ]

    def _switch(self, request):
        if request.start_controllers:
            return True
        if self._time_left is not None:
            threading.Timer(self._time_left, self.close).start()
        raise rospy.ServiceException("not any more")

    def close(self):
        for service in self._services:
            service.shutdown()


class EndingsTest(unittest.TestCase):
    def end_with(self, manager, namespace, *options, end_at="Started controllers"):
        """Start a spawner at this manager, end it when it says this, and return all that it has said."""
        self.addCleanup(manager.close)
        code, said = run_until(end_at, "spawner", "wheel", *options, namespace=namespace)
        assert code == 0
        return said

    def test_controllers_of_a_manager_that_is_ending_are_not_left_behind(self):
        assert "left behind" not in self.end_with(EndingManager("ending", 0.3), "ending")

    def test_controllers_of_a_manager_that_fails_and_stays_are_left_behind(self):
        assert "Controllers were left behind" in self.end_with(EndingManager("staying", None), "staying")

    def test_spawner_that_waits_for_a_go_ends_without_a_word(self):
        said = self.end_with(EndingManager("waiting", None), "waiting", "--wait-for", "go", end_at="Loading")
        assert "Traceback" not in said

    def test_unspawner_ends_also_when_its_manager_is_gone(self):
        name = "/gone/controller_manager/switch_controller"
        service = rospy.Service(name, SwitchController, lambda request: True)
        code, said = run_until(
            "Stopped wheel", "unspawner", "wheel", namespace="gone", before_end=service.shutdown
        )
        assert code == 0, said
        assert "Controllers were not started again: " in said
        assert "Traceback" not in said

    def test_unspawner_interrupted_before_its_manager_answers_starts_again_what_it_stops(self):
        asked, answers, started = threading.Event(), threading.Event(), []

        def switch(request):
            started.extend(request.start_controllers)
            asked.set()
            return answers.wait(LONG)

        service = rospy.Service("/slow/controller_manager/switch_controller", SwitchController, switch)
        self.addCleanup(service.shutdown)
        unspawner = start("unspawner", "wheel", namespace="slow")
        assert asked.wait(LONG)
        unspawner.send_signal(signal.SIGINT)
        answers.set()
        said, _ = unspawner.communicate(timeout=LONG)
        assert unspawner.returncode == 0, said
        assert started == ["wheel"], said
        assert "Traceback" not in said

    def test_unspawner_of_a_manager_that_fails_says_so(self):
        manager = EndingManager("failing", None)
        self.addCleanup(manager.close)
        unspawner = start("unspawner", "wheel", namespace="failing")
        said, _ = unspawner.communicate(timeout=LONG)
        assert unspawner.returncode == 1
        assert "Controllers were not stopped: " in said
        assert "Traceback" not in said


if __name__ == "__main__":
    rospy.init_node("endings_test")
    rostest.rosrun("controller_manager", "endings", EndingsTest)
