"""A judged race of planners that speak ROS 2: python3 -m f1tenth_judge.drivers.ros2 PLACE COMMAND."""

import argparse
import sys
from pathlib import Path

from f1tenth_judge.drivers.ros2.starting import drivers_on_dds
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.results.console import ProgressLine, summary
from f1tenth_judge.run.execute import execute
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.stop_request import StopRequest

_BAD_INPUT = 2
_PLACE = "name of a circuit or world, or the path of a .world file or of the YAML file of a map"
_SET = "replace a value of the scenario, as in seed=2, mu=0.3 or limits.timeout=20"


def main() -> int:
    """Run and judge the race; returns 0 if every lap was driven, 1 if not, 2 for bad input."""
    options = _parser().parse_args()
    try:
        planners = [Driver(ros2=command) for command in options.command]
        race = Race(options.place, options.laps, planners)
        plan = plan_race(race, (options.results / race.name).resolve(), options.set)
        progress = ProgressLine(plan.name)
        with StopRequest().listening() as stop:
            result = execute(plan, drivers_on_dds(), stop, progress.update)
    except ScenarioError as error:
        print(f"f1tenth_judge: {error}", file=sys.stderr)
        return _BAD_INPUT
    progress.clear()
    print(summary(result, plan))
    return 0 if result.passed else 1


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python3 -m f1tenth_judge.drivers.ros2", description=__doc__)
    parser.add_argument("place", metavar="PLACE", help=_PLACE)
    parser.add_argument("command", nargs="+", metavar="COMMAND", help="starts a planner; two: a race of two")
    parser.add_argument("--laps", type=int, default=1, metavar="N", help="default: 1")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help=_SET)
    parser.add_argument("--results", type=Path, default=Path("results"), metavar="FOLDER")
    return parser


if __name__ == "__main__":
    sys.exit(main())
