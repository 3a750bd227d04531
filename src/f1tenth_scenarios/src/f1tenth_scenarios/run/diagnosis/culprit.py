"""Who broke the set-up, and what that node said last."""

import dataclasses
import glob
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Optional

from f1tenth_judge.drivers.proxy_driver import EXIT_NOT_AT_REST
from f1tenth_judge.plan.participants import PROXY_DRIVER, driver_nodes_among
from f1tenth_judge.plan.plan import Plan
from f1tenth_judge.record.observations import Failure, RaceState, RaceUpdate
from f1tenth_judge.run.log_excerpt import (
    LINE_COUNT,
    TRACEBACK,
    exception_in,
    last_lines,
    last_traceback,
    quoted,
)

from f1tenth_scenarios.launch.launch_events import NodeEnd

_NOT_AT_REST = "has not come to rest within {:g} s of wall time (limits.answer)"
_ERROR_WORDS = ("[ERROR]", "[FATAL]", TRACEBACK)

# Of any node and of roslaunch, which may come between the lines of a traceback.
_SAID_TO_ALL = re.compile(r"\[(DEBUG|INFO|WARN|ERROR|FATAL)\] |process\[")


@dataclasses.dataclass(frozen=True)
class Signs:
    """What shows that the set-up broke."""

    ends: Sequence[NodeEnd]  # nodes that ended though they should not have, in order
    lost: Sequence[RaceUpdate]  # race managers that lost their planner or were told to stop
    exit_code: Optional[int]  # of roslaunch, nothing while it runs
    simulator: Mapping[str, Any]  # what the simulator wrote at its end, empty if nothing
    started: Sequence[str] = ()  # nodes
    hindered: Optional[tuple[str, str]] = None  # a process that is there and cannot go on, and why


def failure_of(plan: Plan, signs: Signs) -> Failure:
    """Name what is stuck, else what the simulator waited for, else the simulator, else what ended first."""
    participant, error = signs.simulator.get("participant"), signs.simulator.get("error")
    by_name = {end.node: end for end in reversed(signs.ends)}
    proxies = {car: by_name.get(f"{car}/{PROXY_DRIVER}") for car in plan.cars}
    given_up = next((car for car, proxy in proxies.items() if _gave_its_driver_up(proxy)), None)
    dead = not given_up and (participant in by_name or (signs.ends and not participant))
    if signs.hindered and not dead:
        return _node_failure(plan, NodeEnd(signs.hindered[0], 0), signs.hindered[1])
    if given_up:
        nodes = driver_nodes_among(given_up, signs.started)
        return failure_of_driver(plan, given_up, nodes, _NOT_AT_REST.format(plan.scenario.limits.answer))
    waiting = next((car for car in plan.cars if participant == f"{car}/{PROXY_DRIVER}"), None)
    if waiting and not proxies[waiting]:
        why = (error or "fell silent").replace(f"participant {participant}", "it")
        nodes = driver_nodes_among(waiting, signs.started)
        return failure_of_driver(plan, waiting, nodes, f"does not come to rest: {why}")
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
    said = last_lines(plan.launch_log)
    why = "" if signs.started else _why_nothing_starts(said)
    reason = f"ended with exit code {signs.exit_code}{why}"
    return Failure("roslaunch", reason, str(plan.launch_log), tuple(said[-LINE_COUNT:]))


def _gave_its_driver_up(proxy: Optional[NodeEnd]) -> bool:
    return proxy is not None and proxy.exit_code == EXIT_NOT_AT_REST


def failure_of_driver(plan: Plan, car: str, nodes: Sequence[str], reason: str) -> Failure:
    """A car's driver is of no use: its node that reported an error, else the first, else its launch file."""
    ends = [NodeEnd(node, 0) for node in nodes]
    if not ends:
        return _node_failure(plan, NodeEnd(f"{car} ({plan.cars[car].driver.path})", 0), reason)
    failures = [_node_failure(plan, end, reason) for end in ends]
    return next((each for each in failures if any(map(_tells_of_error, each.log_lines))), failures[0])


def _why_nothing_starts(said: Sequence[str]) -> str:
    """What roslaunch says of a launch file that it cannot read: its last words but for where it looked."""
    words = [line for line in said if not line.startswith(("...", "ROS path", "The traceback"))]
    return f": {words[-1]}" if words else ""


def _lost_failure(plan, update):
    node = "move_base" if update.state is RaceState.LOST else "race_mgr"
    return _node_failure(plan, NodeEnd(f"{update.car}/{node}", 0), update.reason)


def _node_failure(plan, end, reason):
    for file, lines in _last_words(plan, end):
        if lines:
            raised = exception_in(lines) if _may_have_raised(end) else ""
            why = f"{reason}; it raised {raised}" if raised else reason
            return Failure(end.node, why, str(file), tuple(quoted(lines)))
    return Failure(end.node, reason, str(plan.launch_log), tuple(last_lines(plan.launch_log, LINE_COUNT)))


def _may_have_raised(end: NodeEnd) -> bool:
    """Whether an exception is why: not if it was killed, or ended well, which rospy's threads may not."""
    return end.exit_code > 0 or (end.exit_code == 0 and end.said is None)


def _last_words(plan: Plan, end: NodeEnd) -> Iterator[tuple[Path, list[str]]]:
    """What a node may have said last, the most telling first: files and lines."""
    output = last_lines(plan.launch_log)
    own_log = _log_file(plan, end)
    own = last_lines(own_log) if own_log else []
    if end.exit_code:
        yield plan.launch_log, _last_traceback(last_lines(plan.launch_log, until=end.said))
    if own_log:
        yield own_log, _from_last_error(own)
    yield plan.launch_log, [line for line in output if f"[/{end.node}]" in line or f"[{end.node}]" in line]
    if own_log:
        yield own_log, own


def _last_traceback(output: list[str]) -> list[str]:
    """The last one before the end of a node was noticed: an uncaught exception goes to its stderr."""
    return last_traceback([line for line in output if not _SAID_TO_ALL.match(line)])


def _from_last_error(lines: list[str]) -> list[str]:
    """The last error and what follows it: the traceback of a callback, for example."""
    begins = [number for number, line in enumerate(lines) if _tells_of_error(line)]
    return lines[begins[-1] :] if begins else []


def _tells_of_error(line: str) -> bool:
    return any(word in line for word in _ERROR_WORDS)


def _log_file(plan: Plan, end: NodeEnd) -> Optional[Path]:
    """The node's own log, the one that was written to last."""
    stem = glob.escape(end.node.replace("/", "-"))
    patterns = [end.log_file] if end.log_file else [str(plan.log_folder / "*" / f"{stem}-*.log")]
    files = [Path(name) for pattern in patterns for name in glob.glob(pattern)]
    filled = [file for file in files if file.stat().st_size]
    return max(filled, key=lambda file: file.stat().st_mtime, default=None)
