"""The command line of `f1tenth`."""

import argparse
from pathlib import Path
from typing import Callable, TypeAlias

from f1tenth_judge.cli.compare_command import compare
from f1tenth_judge.cli.league_command import league
from f1tenth_judge.cli.race_command import race
from f1tenth_judge.cli.reference_command import reference
from f1tenth_judge.cli.run_command import run
from f1tenth_judge.cli.show_commands import check, export, report, show_keys, show_list
from f1tenth_judge.cli.suite_command import suite
from f1tenth_judge.cli.sweep_command import sweep
from f1tenth_judge.cli.verify_command import verify
from f1tenth_judge.plan.named_planner import OUR_PLANNERS
from f1tenth_judge.record.files import REPORT_FILE
from f1tenth_judge.scenario.driver import Interface

_WATCH = (
    "print an address at which browsers of this machine show what is run while it goes on, then the report"
)
_SET = "replace a value of the file, as in seed=2, mu=0.3, limits.timeout=20 or driver.arguments.speed=4"
_BAG = "keep the bag, also of runs that pass"
_REPEAT = "run N times each, and say how much the results differ"
_VARY = "FIRST:LAST (whole numbers), FIRST:LAST:COUNT or A,B,C; several keys: every combination"
_TABLE = "one more table of the runs: FILE.parquet keeps types, FILE.csv is text"
_AGAINST = "results to compare with; default: those of the commit before, which each run keeps"
_PATH = "look for scenarios, worlds, goals and circuits in FOLDER's folders of these names, too"
_ROS2 = (
    "command that starts a planner of ROS 2, which finds the topics of f1tenth_gym_ros; no ROS 1 is started"
)
_PLACE = "name of a circuit or world, or the path of a .world file or of the YAML file of a map"
_PLANNER = f"launch file of a planner, FILE.py:CLASS, or one of ours ({OUR_PLANNERS})"

_Subparsers: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"


def make_parser(program: str) -> argparse.ArgumentParser:
    """What the command takes; an `action` that takes the options, or a `command` that is watched."""
    parser = argparse.ArgumentParser(prog=program, description="Runs and judges scenarios of the F1/10 car.")
    parser.add_argument("--path", type=_folder, metavar="FOLDER", help=_PATH)
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    _add_shows(commands)
    _add_run(commands)
    _add_race(commands)
    _add_sweep(commands)
    _add_suite(commands)
    _add_league(commands)
    _add_reference(commands)
    _add_compare(commands)
    _add_verify(commands)
    _add_report(commands)
    _add_export(commands)
    _add_watch_command(commands)
    return parser


def _folder(text: str) -> Path:
    if not Path(text).is_dir():
        raise argparse.ArgumentTypeError(f"{text}: no such folder")
    return Path(text)


def _command(commands: _Subparsers, name: str, action: Callable, text: str) -> argparse.ArgumentParser:
    command = commands.add_parser(name, help=text, description=text)
    command.set_defaults(action=action)
    # Of another name, as its default would take the place of what stands before the command.
    command.add_argument("--path", dest="search_path", type=_folder, metavar="FOLDER", help=_PATH)
    return command


def _add_shows(commands: _Subparsers) -> None:
    _command(commands, "list", show_list, "print the scenarios and what each of them tests")
    _command(commands, "keys", show_keys, "print all keys of a scenario file")
    command = _command(commands, "check", check, "validate scenarios without running them")
    command.add_argument("names", nargs="*", metavar="NAME", help="scenario or file; default: all")


def _add_run(commands: _Subparsers) -> None:
    command = _command(commands, "run", run, "run scenarios; exit code 0 if each ended as expected")
    command.add_argument("names", nargs="*", metavar="NAME", help="scenario or file")
    command.add_argument("--all", action="store_true", help="run all scenarios")
    _add_name(command, "that of the scenario")
    _add_other_planner(command)
    command.add_argument(
        "--reference-limits", action="store_true", help="judge by the limits of our planner, too"
    )
    _add_driving(command, "write to FOLDER/NAME", "1")
    _add_shown(command)


def _add_race(commands: _Subparsers) -> None:
    text = "run and judge a race that is in no scenario file"
    command = _command(commands, "race", race, text)
    command.add_argument("place", metavar="PLACE", help=_PLACE)
    command.add_argument("--laps", type=int, default=1, metavar="N", help="default: 1")
    command.add_argument(
        "--planner",
        action="append",
        default=[],
        metavar="LAUNCH",
        help=f"{_PLANNER}; twice: a race of two; default: race",
    )
    command.add_argument(
        "--ros2", action="append", default=[], metavar="COMMAND", help=f"{_ROS2}; twice: a race of two"
    )
    command.add_argument(
        "--description", metavar="FILE", help="URDF or xacro file of the cars; default: the F1/10 car"
    )
    command.add_argument(
        "--timeout", type=float, metavar="S", help="simulated time; default: by the length of the road"
    )
    command.add_argument(
        "--save", type=Path, metavar="FILE", help="write the race as a scenario file, and do not run it"
    )
    command.add_argument(
        "--attach", action="store_true", help="use the ROS master that runs, so that one can look on"
    )
    _add_name(command, "race_PLACE")
    _add_driving(command, "write to FOLDER/NAME", "1")
    _add_shown(command)


def _add_other_planner(
    command: argparse.ArgumentParser, drives: str = "drive with it instead of ours"
) -> None:
    command.add_argument("--planner", metavar="LAUNCH", help=f"{drives}: {_PLANNER}")
    command.add_argument("--ros2", metavar="COMMAND", help=f"{drives}: {_ROS2}")


def _add_driving(command: argparse.ArgumentParser, where: str, at_once: str) -> None:
    """Options of every command that drives, besides --planner and --ros2, of which a race may have two."""
    _add_planner(command)
    command.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help=_SET)
    command.add_argument("--seeds", metavar="A:B", help="run with each of these seeds, as in 1:20 or 3,5")
    command.add_argument("--repeat", type=int, metavar="N", help=_REPEAT)
    # The second name is that of earlier versions.
    command.add_argument(
        "--jobs",
        "--workers",
        dest="workers",
        type=int,
        metavar="N",
        help=f"run N at a time; default: {at_once}",
    )
    command.add_argument("--bag", action="store_true", help=_BAG)
    command.add_argument("--watch", action="store_true", help=_WATCH)
    _add_results(command, where)


def _add_shown(command: argparse.ArgumentParser) -> None:
    command.add_argument("--report", action="store_true", help="write the report afterwards")


def _add_name(command: argparse.ArgumentParser, default: str) -> None:
    command.add_argument("--name", metavar="NAME", help=f"of the results folder; default: {default}")


def _add_planner(command: argparse.ArgumentParser) -> None:
    names = [each.value for each in Interface]
    command.add_argument(
        "--interface",
        choices=names,
        default=Interface.NATIVE.value,
        help="topics of the planner; default: native",
    )
    command.add_argument(
        "--arg",
        action="append",
        default=[],
        metavar="NAME:=VALUE",
        help="argument of the planner's launch file; in a race, of each that has it",
    )


def _add_sweep(commands: _Subparsers) -> None:
    command = _command(commands, "sweep", sweep, "run many variations of a scenario in parallel")
    command.add_argument("name", metavar="NAME", help="scenario or file")
    command.add_argument("--vary", action="append", required=True, metavar="KEY=VALUES", help=_VARY)
    command.add_argument("--output", type=Path, metavar="FILE", help=_TABLE)
    _add_other_planner(command)
    _add_many(command, "write to FOLDER/sweep/NAME")


def _add_suite(commands: _Subparsers) -> None:
    command = _command(commands, "suite", suite, "run many cases, and say how many a planner passes")
    command.add_argument("name", nargs="?", metavar="NAME", help="default: list the suites")
    command.add_argument("--cases", metavar="A,B", help="some of the cases: seeds, as in 0:59, or names")
    command.add_argument("--opponent", metavar="LAUNCH", help="drives the other car of 'encounters'")
    _add_other_planner(command)
    _add_many(command, "write to FOLDER/suite/NAME")


def _add_league(commands: _Subparsers) -> None:
    text = "race planners against the clock and each other at many places, and rank them on a page"
    command = _command(commands, "league", league, text)
    command.add_argument("file", type=Path, metavar="FILE", help="YAML: planners, places, laps, seeds, pairs")
    _add_other_planner(command, "takes part besides those of the file")
    _add_many(command, "write to FOLDER/league/NAME")


def _add_many(command: argparse.ArgumentParser, where: str) -> None:
    _add_driving(command, where, "one per core")
    command.add_argument("--scheduler", metavar="URI", help="use this Dask cluster, as in tcp://host:8786")


def _add_reference(commands: _Subparsers) -> None:
    text = "compute the fastest flying lap that is possible for the simulator's car; minutes for a long road"
    command = _command(commands, "reference", reference, text)
    command.add_argument(
        "names", nargs="*", metavar="NAME", help="circuit, or X_centerline.csv; default: all circuits"
    )
    command.add_argument("--clearance", type=float, metavar="M", help="beside the car; default: 0.05")
    command.add_argument("--output", type=Path, metavar="FOLDER", help="write NAME_raceline.csv there")
    command.add_argument("--laps", type=Path, metavar="FILE", help="write the lap times there, as YAML")


def _add_compare(commands: _Subparsers) -> None:
    text = "compare runs with those of another commit or planner; exit code 1 if something became worse"
    command = _command(commands, "compare", compare, text)
    command.add_argument("base", type=Path, metavar="BASE", help="results folder or run to compare with")
    command.add_argument("head", type=Path, metavar="HEAD", help="results folder or run that is compared")
    command.add_argument(
        "--lap-time", metavar="+N%", help="how much slower the best lap may be; default: not compared"
    )
    command.add_argument(
        "--clearance",
        metavar="-M",
        help="how much less the minimum clearance may be, m; default: not compared",
    )
    command.add_argument(
        "--junit", type=Path, metavar="FILE", help="write a JUnit file, a test case per scenario"
    )


def _add_verify(commands: _Subparsers) -> None:
    text = "run the scenario of a result again; exit code 0 if its trajectory is the same, bit for bit"
    command = _command(commands, "verify", verify, text)
    command.add_argument("result", type=Path, metavar="RESULT", help="a result.json, or its folder")
    command.add_argument(
        "--scenario", metavar="FILE", help="its scenario file; default: the scenario of this name"
    )
    _add_results(command, "write to FOLDER/verify/NAME")


def _add_report(commands: _Subparsers) -> None:
    command = _command(commands, "report", report, "write one HTML file with all runs and their replays")
    _add_results(command, "read FOLDER/*")
    command.add_argument("--against", type=Path, metavar="FOLDER", help=_AGAINST)
    command.add_argument(
        "--output", type=Path, metavar="FILE", help=f"default: {REPORT_FILE} in the results folder"
    )


def _add_export(commands: _Subparsers) -> None:
    command = _command(commands, "export", export, "draw a run: FILE.svg, .png, .pdf, or .gif, which moves")
    command.add_argument("run", type=Path, metavar="RUN", help="name of a run, or its folder")
    command.add_argument("output", type=Path, metavar="FILE", help="what is drawn, by its suffix")
    _add_results(command, "read FOLDER/RUN")


def _add_watch_command(commands: _Subparsers) -> None:
    text = "show in browsers what another command runs while it goes on, as its option --watch does"
    command = commands.add_parser("watch", help=text, description=text)
    command.add_argument(
        "command",
        nargs=argparse.REMAINDER,
        metavar="COMMAND",
        help="race, run, suite or league, with its options",
    )


def _add_results(command: argparse.ArgumentParser, text: str) -> None:
    default = "$F1TENTH_RESULTS, else ./results"
    command.add_argument("--results", type=Path, metavar="FOLDER", help=f"{text}; default: {default}")
