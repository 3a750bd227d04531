"""Episodes of an environment, written down as runs of scenarios are, and their report with a replay."""

import dataclasses
import time
from pathlib import Path

import numpy as np
from f1tenth_sim2d.environments.stage import Stage

from f1tenth_judge.record.files import REPLAY_FILE, REPORT_FILE, RESULT_FILE, TRAJECTORY_FILE
from f1tenth_judge.record.record import read_record
from f1tenth_judge.record.replay import Replay, write_replay
from f1tenth_judge.record.scene import scene_of
from f1tenth_judge.report.page import write_report
from f1tenth_judge.results import versions
from f1tenth_judge.results.result_file import write_result


def scene_of_stage(stage: Stage) -> Replay:
    """What stands around the cars of an environment."""
    scene = scene_of(stage.place.world, {car.name: car for car in stage.cars})
    road = () if stage.place.centreline is None else stage.place.centreline[:, :2].tolist()
    return dataclasses.replace(scene, road=road)


class Recorder:
    """Writes each episode into a folder of its own, and the report when all are over.

    What is written is what a scenario leaves behind: trajectory.csv, replay.json.gz and result.json.
    """

    def __init__(self, folder, stage: Stage):
        """Make the folder.

        Raises:
            ValueError: there are already episodes in it.
            OSError: it cannot be made.
        """
        self._folder, self._stage = Path(folder), stage
        self._folder.mkdir(parents=True, exist_ok=True)
        if any(self._folder.glob("*/result.json")):
            raise ValueError(f"record: found episodes in {folder}, allowed is a folder without")
        self._count, self._begun = 0, False

    def begin(self) -> None:
        """Begin to record an episode; one in progress is given up."""
        self.end("aborted", "given up")
        self._count += 1
        self._run.mkdir()
        self._stage.record(self._run / "trajectory.csv")
        self._laps: list = [[] for _ in self._stage.cars]
        self._started = time.monotonic()
        self._begun = True

    def note(self, over: bool) -> None:
        """Take note of a step, and of the end of the episode."""
        results, now = self._stage.results[0], float(self._stage.times[0])
        for times, laps in zip(self._laps, results["laps"]):
            if laps > len(times):
                times.append(now - sum(times))
        wanted = self._stage.settings.laps
        if not over:
            return
        if wanted and results["laps"][0] >= wanted:
            self.end("success", f"{self._stage.cars[0].name} drove its laps")
        elif self._stage.out_of_time()[0]:
            self.end("timeout", f"not finished after {now:g} s")
        else:
            self.end("collision", f"{self._stage.cars[0].name} touched something")

    def end(self, verdict: str, reason: str) -> None:
        """Write down the episode in progress, if there is one."""
        if not self._begun:
            return
        self._begun = False
        self._stage.record(None)
        record = read_record(self._run / TRAJECTORY_FILE)
        write_replay(self._run / REPLAY_FILE, scene_of_stage(self._stage))
        result = {**self._result(record), "verdict": verdict, "reason": reason}
        result["passed"] = verdict == result["expected"]
        write_result(self._run / RESULT_FILE, result)

    def close(self) -> None:
        """Write the report."""
        self.end("aborted", "given up")
        if self._count:
            write_report(self._folder, self._folder / REPORT_FILE)

    @property
    def _run(self):
        return self._folder / f"episode_{self._count:04d}"

    def _result(self, record):
        tracks = record.tracks
        laps = {
            car.name: {"lap_times": times, "goals_passed": []}
            for car, times in zip(self._stage.cars, self._laps)
        }
        return {
            "scenario": self._run.name,
            "description": f"An episode of {len(laps)} car{'s' if len(laps) > 1 else ''}.",
            "world": self._stage.place.name,
            "expected": "success" if self._stage.settings.laps else "timeout",
            "times": {
                "start": 0.0,
                "finish": record.end,
                "lap_time": min((lap for each in self._laps for lap in each), default=None),
                "wall": round(time.monotonic() - self._started, 3),
                "cost": None,
            },
            "cars": laps,
            "minimum_clearance": min(
                (float(np.min(each.clearance)) for each in tracks.values()), default=None
            ),
            "contacts": [
                dataclasses.asdict(contact) for each in tracks.values() for contact in each.contact_list()
            ],
            "trajectory_hash": record.hash_at_end(),
            "versions": versions.collect({}),
        }
