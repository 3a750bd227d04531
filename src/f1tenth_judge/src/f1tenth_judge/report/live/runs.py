"""The runs that are watched together: those of a league, or a single one."""

import dataclasses
import threading
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.record.files import RESULT_FILE, read_json
from f1tenth_judge.report.live.feed import Feed, Place
from f1tenth_judge.report.live.task import scene_of_task, task_of

_WAITING, _DRIVING, _OVER = "waiting", "driving", "over"
_PATIENCE = 10  # looks at the runs that drive, for one at the others
_SHOWN = ("verdict", "expected", "passed", "reason", "criteria", "times", "cars")  # keys of a result
_PATH_ROWS = 50  # of a car that has stopped

Message = tuple[str, dict[str, Any]]  # name and content


@dataclasses.dataclass
class Watcher:
    """How much somebody who watches has been told."""

    changes: dict[str, int] = dataclasses.field(default_factory=dict)  # by run
    places: dict[str, Place] = dataclasses.field(default_factory=dict)  # of the runs that drive


class Runs:
    """What goes on in all of them; any thread may ask for news."""

    def __init__(self, tasks: Sequence[Mapping[str, Any]]):
        """`tasks`: of task_of, of task_of_job, or of task_of_stage."""
        self._runs = {task["name"]: _Run(task) for task in tasks}
        self._changed = threading.Condition()
        self._looks = 0
        self.end: Optional[dict[str, Any]] = None

    def poll(self) -> None:
        """Read what has been written since the last call."""
        with self._changed:
            everyone = self._looks % _PATIENCE == 0
            self._looks += 1
            news = [run.poll() for run in self._runs.values() if everyone or run.state == _DRIVING]
            if any(news):
                self._changed.notify_all()

    def renew(self, task: Mapping[str, Any]) -> None:
        """There are other cars in a run, as its task says."""
        with self._changed:
            self._runs[task["name"]].renew(task)
            self._changed.notify_all()

    def finish(self, end: dict[str, Any]) -> None:
        """All is over."""
        with self._changed:
            self.end = end
            self._changed.notify_all()

    def is_last_page(self, path: str) -> bool:
        """Whether it is the one that watchers are sent to at the end."""
        return self.end is not None and path == self.end.get("page", "").partition("#")[0]

    def news(self, watcher: Watcher, patience: float) -> list[Message]:
        """What a watcher has not been told yet; nothing if there is no news in time (s)."""
        with self._changed:
            said = self._news(watcher)
            if not said and self.end is None:
                self._changed.wait(patience)
                said = self._news(watcher)
            return said

    def scene(self, name: str) -> dict[str, Any]:
        """What stands around the cars of a run, as the page of a report has it."""
        return self._runs[name].scene()

    def _news(self, watcher: Watcher) -> list[Message]:
        said: list[Message] = []
        for name, run in self._runs.items():
            if watcher.changes.get(name) != run.changes:
                watcher.changes[name] = run.changes
                said.append(("standing", {"run": name, **run.standing()}))
            if run.state != _DRIVING:
                watcher.places.pop(name, None)
            elif news := run.feed.news(watcher.places.setdefault(name, Place())):
                said.append(("news", {"run": name, **news}))
        return said


class _Run:
    def __init__(self, task: Mapping[str, Any]):
        self._task = task
        self._is_job = "scenario" in task
        self._scene: Optional[dict[str, Any]] = task.get("scene")
        self._lock = threading.Lock()  # of the scene, which takes time
        self._path: list = []
        self._result: dict[str, Any] = {}
        self._known: Optional[int] = None  # which result.json that is: when it was written
        self.state, self.changes = _WAITING, 0
        self.feed = self._new_feed()
        self._end_if_over()

    def poll(self) -> bool:
        """Look at its files; returns whether there is news."""
        if self.feed.poll():
            if self.state == _OVER:
                self._known = self._written()
            if self.state != _DRIVING:
                self._change(_DRIVING)
            return True
        return self.state == _DRIVING and self._end_if_over()

    def renew(self, task: Mapping[str, Any]) -> None:
        """Tell all anew, with what another task of its says."""
        with self._lock:
            self._task, self._scene = task, task.get("scene")
        self.feed.tell_again()

    def standing(self) -> dict[str, Any]:
        """In what state it is, and what came out."""
        return {"state": self.state, "result": self._result, "path": self._path}

    def scene(self) -> dict[str, Any]:
        """As of scene_of_task, kept while the run is driven."""
        with self._lock:
            if self._scene is None:
                self._scene = scene_of_task(self._whole_task())
            return self._scene

    def _whole_task(self) -> Mapping[str, Any]:
        if not self._is_job:
            return self._task
        plan = make_plan(self._task["scenario"], Path(self._task["folder"]), self._task["settings"])
        return task_of(plan)

    def _new_feed(self, since: Optional[float] = None) -> Feed:
        if not self._is_job:
            return Feed(Path(self._task["record"]), Path(self._task["interventions"]))
        log = Path(self._task["folder"]) / "log"
        return Feed(log / "record.csv", log / "interventions.jsonl", since)

    def _end_if_over(self) -> bool:
        """Whether a job has a new result; how a single run ends is told."""
        written = self._written()
        if written == self._known:
            return False
        self._known = written
        read = read_json(Path(self._task["folder"]) / RESULT_FILE)
        self._result = {key: read[key] for key in _SHOWN if key in read}
        self._path = self.feed.paths(_PATH_ROWS)
        self._scene = None
        # What was written before the result belongs to the run that is over.
        self.feed = self._new_feed(since=written * 1e-9 if written else None)
        self._change(_OVER)
        return True

    def _written(self) -> Optional[int]:
        """When the result of a job was written."""
        try:
            return (Path(self._task["folder"]) / RESULT_FILE).stat().st_mtime_ns if self._is_job else None
        except OSError:
            return None

    def _change(self, state: str) -> None:
        self.state = state
        self.changes += 1
