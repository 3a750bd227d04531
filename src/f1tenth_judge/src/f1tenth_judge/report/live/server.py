"""The watchers' side: the page, its events (text/event-stream), and the files of the results."""

import functools
import http.server
import json
import threading
from pathlib import Path
from typing import Any, Callable

from f1tenth_judge.report.live.runs import Runs, Watcher

_OWN_NAMES = ("127.0.0.1", "localhost")
_MOST_WATCHERS = 32
_PAUSE = 0.05  # s, between two messages to a watcher
_HEARTBEAT = 5.0  # s, after which a watcher without news hears that, and one who has left is noticed
_PATIENCE = 30.0  # s, with a link that takes nothing


class Server(http.server.ThreadingHTTPServer):
    """Serves runs to the browsers of this machine."""

    daemon_threads = True

    def __init__(self, runs: Runs, page: Callable[[], str], results: Path):
        """`page`: what a watcher gets first; `results`: files served beside."""
        super().__init__(("127.0.0.1", 0), functools.partial(_Handler, directory=str(results)))
        self.runs, self.page = runs, page
        self.watchers = threading.Semaphore(_MOST_WATCHERS)
        self.moving_on = 0  # watchers who were told the end and have not come for the report yet

    @property
    def address(self) -> str:
        """For a browser."""
        return f"http://127.0.0.1:{self.server_port}/"

    def handle_error(self, request, client_address) -> None:
        """Nothing: watchers come and go."""


class _Handler(http.server.SimpleHTTPRequestHandler):
    server: Server
    timeout = _PATIENCE

    def do_GET(self) -> None:
        """Answer who asks for this address by its own name, so that no page from elsewhere can."""
        if self.headers.get("Host") not in [f"{name}:{self.server.server_port}" for name in _OWN_NAMES]:
            self.send_error(403)
        elif self.path == "/":
            self._send_page()
        elif self.path == "/events":
            self._send_events()
        else:
            super().do_GET()
            self.server.moving_on -= self.server.runs.is_last_page(self.path)

    def log_message(self, *_) -> None:
        """Nothing."""

    def _send_page(self) -> None:
        body = self.server.page().encode()
        self.send_response(200)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def _send_events(self) -> None:
        if not self.server.watchers.acquire(blocking=False):
            self.send_error(503)
            return
        try:
            self._stream()
        finally:
            self.server.watchers.release()

    def _stream(self) -> None:
        self.send_response(200)
        self.send_header("Content-Type", "text/event-stream")
        self.send_header("Cache-Control", "no-store")
        self.end_headers()
        runs, watcher, pause = self.server.runs, Watcher(), threading.Event()
        while True:
            end = runs.end  # before the last news, or that would be lost
            said = runs.news(watcher, _HEARTBEAT)
            for kind, content in said:
                if kind == "news" and content["begins"]:
                    self._say("scene", {"run": content["run"], **runs.scene(content["run"])})
                self._say(kind, content)
            if said:
                pause.wait(_PAUSE)
            elif end is not None:
                self.server.moving_on += bool(end.get("page"))
                return self._say("end", end)
            else:
                self._say("alive", None)

    def _say(self, kind: str, content: Any) -> None:
        text = json.dumps(content, separators=(",", ":"))
        self.wfile.write(f"event: {kind}\ndata: {text}\n\n".encode())
