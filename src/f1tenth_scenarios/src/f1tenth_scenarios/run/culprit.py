"""Who broke the set-up, and what that node said last."""

import dataclasses
import glob
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_scenarios.record.observations import Failure, RaceState, RaceUpdate
from f1tenth_scenarios.run.file_tail import last_lines
from f1tenth_scenarios.run.launch_log import NodeEnd
from f1tenth_scenarios.scenario.plan import Plan

_LINE_COUNT = 10


@dataclasses.dataclass(frozen=True)
class Signs:
    """What shows that the set-up broke."""

    ends: Sequence[NodeEnd]  # nodes that ended though they should not have, in order
    lost: Sequence[RaceUpdate]  # race managers that lost their planner or were told to stop
    exit_code: Optional[int]  # of roslaunch, nothing while it runs
    simulator: Mapping[str, Any]  # what the simulator wrote at its end, empty if nothing


def failure_of(plan: Plan, signs: Signs) -> Failure:
    """Name whom the simulator waited for in vain, else the simulator, else the first that ended."""
    participant, error = signs.simulator.get("participant"), signs.simulator.get("error")
    by_name = {end.node: end for end in reversed(signs.ends)}
    if participant in by_name:
        return _node_failure(plan, by_name[participant], by_name[participant].describe())
    if participant:
        return _node_failure(plan, NodeEnd(participant, 0), error or "fell silent")
    if error:
        return _node_failure(plan, by_name.get("sim2d", NodeEnd("sim2d", 0)), error)
    if signs.ends:
        return _node_failure(plan, signs.ends[0], signs.ends[0].describe())
    if signs.lost:
        return _lost_failure(plan, signs.lost[0])
    return Failure(
        "roslaunch",
        f"ended with exit code {signs.exit_code}",
        str(plan.launch_log),
        tuple(last_lines(plan.launch_log, _LINE_COUNT)),
    )


def _lost_failure(plan, update):
    node = "move_base" if update.state is RaceState.LOST else "race_mgr"
    return _node_failure(plan, NodeEnd(f"{update.car}/{node}", 0), update.reason)


def _node_failure(plan, end, reason):
    file = _log_file(plan, end)
    lines = tuple(last_lines(file, _LINE_COUNT)) if file else ()
    if not lines:
        file, lines = plan.launch_log, _lines_of(plan.launch_log, end.node)
    return Failure(end.node, reason, str(file), lines)


def _log_file(plan: Plan, end: NodeEnd) -> Optional[Path]:
    """The node's own log, the one that was written to last."""
    stem = glob.escape(end.node.replace("/", "-"))
    patterns = [end.log_file] if end.log_file else [str(plan.log_folder / "*" / f"{stem}-*.log")]
    files = [Path(name) for pattern in patterns for name in glob.glob(pattern)]
    filled = [file for file in files if file.stat().st_size]
    return max(filled, key=lambda file: file.stat().st_mtime, default=None)


def _lines_of(path: Path, node: str) -> tuple[str, ...]:
    """What a node wrote to roslaunch's output: ROSCONSOLE_FORMAT makes every line name its node."""
    lines = last_lines(path, 1_000_000)
    named = [line for line in lines if f"[/{node}]" in line]
    return tuple((named or lines)[-_LINE_COUNT:])
