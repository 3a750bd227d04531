"""What is broken, and how."""

import dataclasses
import functools
import os
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import psutil

from f1tenth_studies.faults.victim import RUNNER, Victim

SCENARIO = ("rosrun", "f1tenth_scenarios", "scenario")
_RUN = ("run", "circuit1", "--set", "laps=2", "--set", "limits.answer=5", "--set", "limits.wall=60")
DRIVEN = 3.0  # s simulated, before something is broken
_STARTER = "race_starter"  # ends with the start of the race
_LITTLE_MEMORY = 300 << 20  # bytes of address space
_DESCRIPTORS = 64
_PAUSE = 10.0  # wall s, as by Ctrl-Z
_SET_BACK = "set_back"  # file that sets the clock back
# Prefixes of a command: a small or read-only disk in place of the results, which are kept afterwards.
_SMALL_DISK = 'mount -t tmpfs -o size=300k tmpfs "$1" && "${@:3}"; code=$?; cp -r "$1/." "$2"; exit $code'
_READ_ONLY_DISK = 'mount --bind "$1" "$1" && mount -o remount,ro,bind "$1" && exec "${@:3}"'


@dataclasses.dataclass(frozen=True)
class Fault:
    """One thing that breaks."""

    name: str
    start: Callable[[Path], Victim]  # in a folder
    inject: Callable[[Victim, float], Any] = lambda victim, moment: None  # when it has driven that long, s


def node_names(folder: Path) -> list[str]:
    """The nodes of a run, and what runs besides."""
    with _start(folder) as victim:
        victim.wait_for(lambda: victim.has_driven(DRIVEN))
        names = {name for each in victim.members() if (name := victim.name_of(each))}
        victim.process.send_signal(signal.SIGINT)
        victim.end(30.0)
    return sorted(names | {_STARTER})


def faults(nodes: Sequence[str]) -> list[Fault]:
    """All of them."""
    signals = {"killed": signal.SIGKILL, "stopped": signal.SIGSTOP}
    of_nodes = [
        Fault(f"{node} {how}", _start, functools.partial(_signal_node, node, number))
        for node in nodes
        for how, number in signals.items()
        if (node, how) != (RUNNER, "stopped")  # it could not end anything; see _pause_runner
    ]
    return [*of_nodes, *_OTHERS]


def _start(folder: Path, before: Sequence[str] = (), settings: Sequence[str] = (), **popen: Any) -> Victim:
    results = folder / "results"
    results.mkdir()
    command = [*before, *SCENARIO, *_RUN, *settings, "--results", str(results)]
    return Victim(command, results, folder / "said", **popen)


def _start_long(folder: Path) -> Victim:
    """A run that lasts until the command that is to break it has started."""
    return _start(folder, settings=["--set", "laps=20"])


def _signal_node(node: str, number: int, victim: Victim, moment: float) -> None:
    victim.wait_for(lambda: victim.has_driven(min(moment, 0.5) if node == _STARTER else moment))
    process = victim.node(node)
    if process is not None:
        process.send_signal(number)


def _pause_runner(victim: Victim, moment: float) -> None:
    _signal_node(RUNNER, signal.SIGSTOP, victim, moment)
    time.sleep(_PAUSE)
    victim.process.send_signal(signal.SIGCONT)


def _limited(limit: int, value: int) -> Callable[[Path], Victim]:
    def start(folder: Path) -> Victim:
        return _start(folder, preexec_fn=lambda: resource.setrlimit(limit, (value, value)))

    return start


def _on_disk(script: str) -> Callable[[Path], Victim]:
    def start(folder: Path) -> Victim:
        kept = folder / "kept"
        kept.mkdir()
        script_of = ["bash", "-c", script, "disk", str(folder / "results"), str(kept)]
        victim = _start(folder, ["unshare", "--user", "--map-root-user", "--mount", *script_of])
        victim.results = kept
        return victim

    return start


def clock_of_its_own(file: Path) -> dict[str, str]:
    """Variables that set back the system time of one program by an hour, once a file is there."""
    return {"LD_PRELOAD": "libf1tenth_set_back.so", "F1TENTH_SET_BACK": str(file)}


def _start_by_clock(folder: Path) -> Victim:
    return _start(folder, env=clock_of_its_own(folder / _SET_BACK))


def _set_back(victim: Victim, moment: float) -> None:
    victim.wait_for(lambda: victim.has_driven(moment))
    (victim.results.parent / _SET_BACK).touch()


def _subscribe(count: int, reads: bool, victim: Victim, _moment: float) -> None:
    module = [sys.executable, "-m", "f1tenth_studies.faults.subscribers", "/robot1/scan", str(count)]
    _beside(victim, [*module, "reading" if reads else "silent"])


def _pause(victim: Victim, moment: float) -> None:
    victim.wait_for(lambda: victim.has_driven(moment))
    _beside(victim, ["rosservice", "call", "/gazebo/pause_physics"])


def _beside(victim: Victim, command: Sequence[str]) -> None:
    """Start something on the master of a run."""
    simulator = victim.wait_for(lambda: victim.node("sim2d"))
    if simulator is not None:
        environment = {**os.environ, **_master(simulator)}
        victim.beside.append(subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL))


def _master(node: psutil.Process) -> Mapping[str, str]:
    names = ("ROS_MASTER_URI", "ROS_HOSTNAME")
    return {name: value for name, value in node.environ().items() if name in names}


_OTHERS = (
    Fault(f"{RUNNER} stopped for {_PAUSE:g} s", _start, _pause_runner),
    Fault("clock stopped (pause_physics)", _start_long, _pause),
    Fault("system time set back an hour", _start_by_clock, _set_back),
    Fault("disk full", _on_disk(_SMALL_DISK)),
    Fault("read-only results", _on_disk(_READ_ONLY_DISK)),
    Fault(f"{_DESCRIPTORS} descriptors", _limited(resource.RLIMIT_NOFILE, _DESCRIPTORS)),
    Fault("little memory (300 MB)", _limited(resource.RLIMIT_AS, _LITTLE_MEMORY)),
    Fault("200 subscribers of the scan", _start, functools.partial(_subscribe, 200, True)),
    Fault("a subscriber that stops reading", _start, functools.partial(_subscribe, 1, False)),
)
