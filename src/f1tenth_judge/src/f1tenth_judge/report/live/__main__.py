"""Serves runs that other processes drive: python3 -m f1tenth_judge.report.live, which watching.py starts.

The first line of the standard input is the task. Others are the task of a run in which there are other cars
now, or, at last, the page that the watchers are sent to at the end. The address is written to the standard
output. Ends with the runs.
"""

import json
import os
import sys
import threading
import time
from pathlib import Path
from typing import Any

from f1tenth_judge.report.live.runs import Runs
from f1tenth_judge.report.live.server import Server
from f1tenth_judge.report.page import live_page

_PERIOD = 0.05  # wall s, between two looks at the records
_FAREWELL = 10.0  # wall s, at most, for watchers to come for the report


def main() -> None:
    """Serve until all is over and the watchers have the report."""
    task = json.loads(sys.stdin.readline())
    runs = Runs(task["runs"])
    server = Server(runs, lambda: live_page(task["title"], task["runs"]), Path(task["results"]))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    print(server.address, flush=True)
    os.nice(10)
    threading.Thread(target=_wait_for_end, args=(runs,), daemon=True).start()
    while runs.end is None:
        runs.poll()
        time.sleep(_PERIOD)
    _say_goodbye(server)


def _wait_for_end(runs: Runs) -> None:
    end: dict[str, Any] = {}
    for line in sys.stdin:
        said = json.loads(line)
        if "name" in said:
            runs.renew(said)
        else:
            end = said
            break
    runs.poll()
    runs.finish(end)


def _say_goodbye(server: Server) -> None:
    deadline = time.monotonic() + _FAREWELL
    time.sleep(4 * _PERIOD)
    while server.moving_on > 0 and time.monotonic() < deadline:
        time.sleep(_PERIOD)


if __name__ == "__main__":
    main()
