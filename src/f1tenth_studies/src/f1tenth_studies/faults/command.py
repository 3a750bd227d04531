"""The command `faults`."""

import argparse
import contextlib
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Optional

from f1tenth_scenarios.cli.exit_codes import BAD_INPUT, NOT_PASSED, PASSED
from f1tenth_scenarios.cli.options import expect_at_least
from f1tenth_scenarios.errors import ScenarioError

from f1tenth_studies.faults.catalogue import DRIVEN, Fault, faults, node_names
from f1tenth_studies.faults.interrupts import COMMANDS, interrupt
from f1tenth_studies.faults.table import document, problem
from f1tenth_studies.faults.victim import Ending
from f1tenth_studies.files import expect_folder_of, write_text

_PATIENCE = 90.0  # wall s, for a run to end by itself after something broke
_MOMENTS = (0.2, 8.0)  # s simulated, between which a random fault happens


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Run the command; returns the exit code: 1 when an ending was not as it should be."""
    parser = argparse.ArgumentParser(prog="faults", description="Breaks runs; makes a table of their ends.")
    parser.add_argument("--only", default="", metavar="WORDS", help="what has these words in its name")
    parser.add_argument("--random", type=int, default=0, metavar="N", help="as many besides, on busy cores")
    parser.add_argument("--moments", type=int, default=0, metavar="N", help="of SIGINT, for each command")
    parser.add_argument("--seed", type=int, default=1, help="of all that is random (%(default)s)")
    parser.add_argument("--table", type=Path, metavar="FILE", help="write the table there, too")
    options = parser.parse_args(arguments)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        return _run(options)
    except ScenarioError as error:
        print(f"faults: {error}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        return 128 + signal.SIGINT


def _run(options) -> int:
    expect_folder_of(options.table, "--table")
    expect_at_least(0, options.random, "--random")
    expect_at_least(0, options.moments, "--moments")
    folder = Path(tempfile.mkdtemp(prefix="faults."))
    try:
        chosen, names = _chosen(options, node_names(_made(folder / "whole")))
        endings = list(_endings(options, chosen, folder))
        interrupts = [interrupt(name, options.moments, folder / name, options.seed) for name in names]
    except (KeyboardInterrupt, ScenarioError):
        # Nobody will learn of the folder.
        shutil.rmtree(folder)
        raise
    text = document(endings, interrupts, " ".join(["rosrun f1tenth_studies faults", *sys.argv[1:]]))
    print(text)
    if options.table:
        write_text(options.table, text)
    problems = [f"{name}: {what}" for name, ending in endings if (what := problem(ending))]
    problems += [f"{each.command}: {what}" for each in interrupts for what in each.problems]
    return _say(problems, folder)


def _say(problems: Sequence[str], folder: Path) -> int:
    for each in problems:
        print(f"faults: {each}", file=sys.stderr)
    if problems:
        print(f"faults: what was broken is in {folder}", file=sys.stderr)
        return NOT_PASSED
    shutil.rmtree(folder)
    return PASSED


def _chosen(options, nodes: Sequence[str]) -> tuple[list[Fault], list[str]]:
    """The faults to cause and the commands to interrupt.

    Raises:
        ScenarioError: there are none, or no faults to choose random ones from.
    """
    known = faults(nodes)
    chosen = [each for each in known if options.only in each.name]
    commands = [each for each in COMMANDS if options.moments and options.only in each]
    if not chosen and (options.random or not commands):
        raise ScenarioError(
            f"--only '{options.only}': no fault has that in its name, there are:"
            f" {', '.join(each.name for each in known)}; --moments takes the commands: {', '.join(COMMANDS)}"
        )
    return chosen, commands


def _endings(options, chosen: Sequence[Fault], folder: Path) -> Iterator[tuple[str, Ending]]:
    for number, fault in enumerate(chosen):
        yield fault.name, _break(fault, DRIVEN, _made(folder / f"{number:02}"))
    generator = random.Random(options.seed)
    with _busy_cores() if options.random else contextlib.nullcontext():
        for number in range(options.random):
            fault, moment = generator.choice(chosen), generator.uniform(*_MOMENTS)
            name = f"{fault.name}, at {moment:.1f} s, busy cores"
            yield name, _break(fault, moment, _made(folder / f"random{number:02}"))


@contextlib.contextmanager
def _busy_cores() -> Iterator[None]:
    """Keep every core busy while the block runs."""
    command = [sys.executable, "-c", "while True: pass"]
    busy = [subprocess.Popen(command) for _ in os.sched_getaffinity(0)]
    try:
        yield
    finally:
        for each in busy:
            each.kill()
            each.wait()


def _made(folder: Path) -> Path:
    folder.mkdir()
    return folder


def _break(fault: Fault, moment: float, folder: Path) -> Ending:
    with fault.start(folder) as victim:
        fault.inject(victim, moment)
        ending = victim.end(_PATIENCE)
    print(f"faults: {fault.name}: exit code {ending.exit_code}", file=sys.stderr, flush=True)
    return ending
