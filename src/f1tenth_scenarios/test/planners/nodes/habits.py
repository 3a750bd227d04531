#!/usr/bin/env python3
"""Ways in which people let a planner wait for scans; its speed shows how many each command knew of."""

import asyncio
import concurrent.futures
import contextlib
import multiprocessing
import queue
import select
import socket
import subprocess
import sys
import threading
import time

import numpy as np
import rospy
from ackermann_msgs.msg import AckermannDriveStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

PERIOD = 0.025  # s
SHORT = 0.001  # wall s
ECHO = "import sys\nfor line in sys.stdin: print(line, end='', flush=True)"


def nearest(ranges):
    """What a worker computes."""
    return float(np.nanmin(np.clip(ranges, 0.0, 10.0)))


def echo(connection):
    """A process that answers what it is told."""
    while True:
        connection.send(connection.recv())


class Habits:
    def __init__(self):
        self.count = 0
        self.is_away = False
        self.scans = queue.Queue()
        self.changed = threading.Condition()
        self.event = threading.Event()
        self.on_scan = lambda scan: None
        self.publisher = rospy.Publisher("drive", AckermannDriveStamped, queue_size=1)

    def start(self, how):
        """Drive by a habit; subscribed to when all is there that it needs."""
        run = getattr(self, how)()
        rospy.Subscriber("scan", LaserScan, self.take, queue_size=1)
        (run or rospy.spin)()

    def take(self, scan):
        self.count += 1
        self.on_scan(scan)

    def send(self, _=None):
        command = AckermannDriveStamped()
        command.drive.speed = 0.2 + 0.002 * self.count
        self.publisher.publish(command)

    def thread(self, run):
        threading.Thread(target=run, daemon=True).start()

    def loop(self, wait):
        """A loop that waits before each command."""

        def run():
            while not rospy.is_shutdown():
                wait()
                self.send()

        return run

    def answers_in_the_callback(self):
        self.on_scan = self.send

    def answers_every_second_scan(self):
        self.on_scan = lambda scan: self.count % 2 or self.send()

    def loops_at_the_rate_of_scans(self):
        return self.loop(rospy.Rate(40).sleep)

    def loops_more_slowly(self):
        return self.loop(rospy.Rate(10).sleep)

    def loops_more_quickly(self):
        return self.loop(rospy.Rate(200).sleep)

    def has_a_timer(self):
        self.timers = [rospy.Timer(rospy.Duration(PERIOD), self.send)]

    def has_two_timers(self):
        self.timers = [rospy.Timer(rospy.Duration(period), self.send) for period in (0.05, 0.08)]

    def sleeps_between_commands(self):
        return self.loop(lambda: rospy.sleep(2 * PERIOD))

    def polls_the_time(self):
        return self.polling(lambda: time.sleep(SHORT))

    def polls_with_a_condition(self):
        def wait():
            with self.changed:
                self.changed.wait(SHORT)

        return self.polling(wait)

    def polling(self, wait):
        def until_due():
            while rospy.get_time() < self.due and not rospy.is_shutdown():
                wait()
            self.due += PERIOD

        self.due = rospy.get_time()
        return self.loop(until_due)

    def hands_scans_to_a_thread(self):
        self.on_scan = self.scans.put
        self.thread(self.loop(self.scans.get))

    def looks_into_a_queue_now_and_then(self):
        def wait():
            scan = None
            while scan is None and not rospy.is_shutdown():
                with contextlib.suppress(queue.Empty):
                    scan = self.scans.get(timeout=SHORT)

        self.on_scan = self.scans.put
        self.thread(self.loop(wait))

    def is_woken_by_an_event(self):
        def wait():
            self.event.wait()
            self.event.clear()

        self.on_scan = lambda scan: self.event.set()
        self.thread(self.loop(wait))

    def computes_in_a_pool(self):
        pool = concurrent.futures.ThreadPoolExecutor(4)

        def answer(scan):
            list(pool.map(nearest, np.array_split(np.asarray(scan.ranges), 4)))
            self.send()

        self.on_scan = answer

    def asks_another_process(self):
        here, there = multiprocessing.get_context("spawn").Pipe()
        multiprocessing.get_context("spawn").Process(target=echo, args=(there,), daemon=True).start()

        def answer(scan):
            here.send(scan.header.seq)
            here.recv()
            self.send()

        self.on_scan = answer

    def asks_a_program(self):
        pipe = subprocess.PIPE
        program = subprocess.Popen([sys.executable, "-c", ECHO], stdin=pipe, stdout=pipe, text=True)

        def answer(scan):
            program.stdin.write(f"{scan.header.seq}\n")
            program.stdin.flush()
            program.stdout.readline()
            self.send()

        self.on_scan = answer

    def multiplies_matrices(self):
        matrix = np.random.default_rng(7).random((400, 400))

        def answer(_scan):
            np.dot(matrix, matrix)
            self.send()

        self.on_scan = answer

    def computes_for_long(self):
        def answer(_scan):
            sum(number * number for number in range(300_000))
            self.send()

        self.on_scan = answer

    def runs_asyncio(self):
        loop = asyncio.new_event_loop()
        self.thread(loop.run_forever)
        self.on_scan = lambda scan: loop.call_soon_threadsafe(self.send)

    def watches_a_socket(self):
        here, there = socket.socketpair()

        def wait():
            while not select.select([there], [], [], SHORT)[0] and not rospy.is_shutdown():
                pass
            there.recv(1)

        self.on_scan = lambda scan: here.send(b"x")
        self.thread(self.loop(wait))

    def hears_the_odometry_too(self):
        """The newest: how many of a period come through a queue of one is chance in ROS itself."""

        def note(odometry):
            self.is_away = odometry.pose.pose.position.x > 0.1

        def answer(_scan):
            self.count += self.is_away
            self.send()

        rospy.Subscriber("odom", Odometry, note, queue_size=1)
        self.on_scan = answer


if __name__ == "__main__":
    rospy.init_node("planner")
    Habits().start(rospy.get_param("~how"))
