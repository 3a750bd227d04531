"""Serves a run that another process drives: python3 -m f1tenth_judge.report.live, which watching.py starts.

The first line of the standard input is the task; the second, if there is one, the page that the watchers are
sent to at the end. The address is written to the standard output. Ends with the run.
"""

import dataclasses
import functools
import json
import os
import sys
import threading
import time
from pathlib import Path

import f1tenth_sim2d
from f1tenth_judge.record.record import Record
from f1tenth_judge.record.replay import Replay
from f1tenth_judge.record.scene import scene_of
from f1tenth_judge.report.live.feed import Feed
from f1tenth_judge.report.live.server import Server
from f1tenth_judge.report.page import live_page
from f1tenth_judge.report.replay_columns import pack_run, pack_world
from f1tenth_judge.run.stage import models_folder, own_car

_PERIOD = 0.05  # wall s, between two looks at the record
_FAREWELL = 10.0  # wall s, at most, for watchers to come for the report


def main() -> None:
    """Serve until the run is over and its watchers have the report."""
    task = json.loads(sys.stdin.readline())
    feed = Feed(Path(task["record"]), Path(task["interventions"]))
    scene = functools.lru_cache(maxsize=1)(lambda: _scene(task))
    server = Server(feed, lambda: live_page(task), scene, Path(task["results"]))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    print(server.address, flush=True)
    os.nice(10)
    threading.Thread(target=_wait_for_end, args=(feed,), daemon=True).start()
    while feed.end is None:
        feed.poll()
        time.sleep(_PERIOD)
    _say_goodbye(server)


def _wait_for_end(feed: Feed) -> None:
    last = sys.stdin.readline()
    feed.poll()
    feed.finish(json.loads(last) if last else {})


def _say_goodbye(server: Server) -> None:
    deadline = time.monotonic() + _FAREWELL
    time.sleep(4 * _PERIOD)
    while server.moving_on > 0 and time.monotonic() < deadline:
        time.sleep(_PERIOD)


def _scene(task) -> dict[str, str]:
    """What stands around the cars, as the page of a report has it."""
    descriptions = {name: each or own_car() for name, each in task["descriptions"].items()}
    cars = {name: f1tenth_sim2d.load_car(text, name, file) for name, (text, file) in descriptions.items()}
    try:
        scene = scene_of(f1tenth_sim2d.load_world(task["world"], [str(models_folder())]), cars)
    except f1tenth_sim2d.Error:
        scene = Replay()  # the run says what is wrong with it
    shown = dataclasses.replace(scene, goals=task["goals"], road=task["road"])
    return {"run": pack_run(Record({}), shown), "world": pack_world(shown)}


if __name__ == "__main__":
    main()
