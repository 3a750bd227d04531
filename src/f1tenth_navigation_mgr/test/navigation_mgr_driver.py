#!/usr/bin/env python3
"""Drives the Python class as navigation_mgr_driver.cpp drives the C++ one.

navigation_mgr_driver.py ROBOT GOALS_FILE [loop|cancel|parts|add|drop]
"""

import sys

import rospy

from f1tenth_navigation_mgr import Goal, NavigationError, NavigationMgr, SpinResult, Timeouts

LOOPED_GOALS = 5
SPINS_AFTER_END = 5
NO_EVENT = (SpinResult.NOT_CONNECTED, SpinResult.DRIVING, SpinResult.IDLE)


def say(text):
    print(text, flush=True)


def say_result(result):
    say(f"goal {result.goal.x:g} {result.outcome.name.lower()}: {result.text}")


def spin_by_parts(navmgr):
    """The thesis's Spin, with its names."""
    if navmgr.has_active_goal():
        return navmgr.check_goal_state()
    if navmgr.size_goals_queue() > 0:
        return navmgr.send_goal(navmgr.front_goals_queue())
    return navmgr.spin()


def drive(navmgr, mode):
    over = False
    left = SPINS_AFTER_END
    while not rospy.is_shutdown() and left > 0:
        did = spin_by_parts(navmgr) if mode == "parts" else navmgr.spin()
        if did not in NO_EVENT:
            say(did.name.lower())
        if did == SpinResult.SENT and (mode == "cancel" or len(navmgr.results) >= LOOPED_GOALS):
            navmgr.clear_goals()
            navmgr.cancel()
        if did == SpinResult.SENT and mode == "drop":
            navmgr.clear_goals()
        if did == SpinResult.SENT and mode == "add" and not navmgr.results:
            navmgr.add_goal(Goal(9.0, 0.0, 0.0))
        over = over or did == SpinResult.QUEUE_EMPTY
        left -= over


def short_timeouts():
    timeouts = Timeouts()
    timeouts.resend, timeouts.acknowledge, timeouts.disconnect = 1.0, 4.0, 1.0
    timeouts.silence, timeouts.result = 4.0, 1.0
    return timeouts


def main():
    # In the same process, to prove that they get along.
    rospy.init_node("driver", anonymous=True)
    arguments = rospy.myargv()[1:]
    mode = arguments[2] if len(arguments) > 2 else ""
    try:
        navmgr = NavigationMgr(arguments[0], short_timeouts())
        navmgr.load_goals(arguments[1])
    except NavigationError as error:
        say(error)
        return 2
    navmgr.loop_mode = mode == "loop"
    navmgr.on_goal_reached(say_result)
    navmgr.on_goal_failed(say_result)
    drive(navmgr, mode)
    return 0


sys.exit(main())
