"""Episodes of an environment, watched in a browser while a policy learns."""

import tempfile
from pathlib import Path
from typing import Any

from f1tenth_sim2d.environments.stage import Stage

from f1tenth_judge.record.record import Record
from f1tenth_judge.record.row import COLUMNS
from f1tenth_judge.report.episodes import scene_of_stage
from f1tenth_judge.report.live.rows import Rows
from f1tenth_judge.report.live.watching import Serving
from f1tenth_judge.report.replay_columns import pack_run, pack_world

_FELT = COLUMNS[COLUMNS.index("x") : COLUMNS.index("clearance")]  # as results call them, too


class Watch:
    """Serves the episode in progress of the first environment of a stage."""

    def __init__(self, stage: Stage):
        """Begin to serve; the address is printed."""
        self._stage = stage
        self._folder = tempfile.TemporaryDirectory(prefix="f1tenth_watch")
        self._file = Path(self._folder.name) / "record.csv"
        self._rows = Rows(self._file)
        task = task_of_stage(stage, self._file)
        self._serving = Serving([task], task["name"], self._file.parent)

    def begin(self) -> None:
        """Show a new episode."""
        self._rows.begin()
        self.note()

    def note(self) -> None:
        """Take note of a step."""
        time = float(self._stage.times[0])
        for car, result in zip(self._stage.cars, self._stage.results[0]):
            felt = {name: float(result[name]) for name in _FELT}
            self._rows.write(time, car.name, contacts="something" if result["contact"] else "", **felt)
        self._rows.flush()

    def close(self) -> None:
        """Stop serving."""
        self._rows.close()
        self._serving.close()
        self._folder.cleanup()


def task_of_stage(stage: Stage, record: Path) -> dict[str, Any]:
    """Of an environment that is recorded into a file."""
    shown = scene_of_stage(stage)
    about = {"description": f"The episode in progress in {stage.place.name}.", "cars": {}}
    return {
        "name": f"environment {stage.place.name}",
        "record": str(record),
        "interventions": str(record.with_name("none")),
        "scene": {"columns": pack_run(Record({}), shown), "world": pack_world(shown), "about": about},
    }
