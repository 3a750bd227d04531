"""scenario race."""

import dataclasses
import re
from pathlib import Path
from typing import Optional

from f1tenth_judge.atomic import replacing
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.plan.race import Race, plan_race, race_text
from f1tenth_judge.scenario.driver import Driver

from f1tenth_scenarios.cli.exit_codes import PASSED
from f1tenth_scenarios.cli.options import (
    check_planner_options,
    expect_at_least,
    file_option,
    planners_of,
    results_of,
    ros2_planners,
)
from f1tenth_scenarios.cli.run_command import check_repeat, run_plan, run_repeatedly, with_report


def race(options) -> int:
    """Run and judge a race that is in no scenario file."""
    expect_at_least(1, options.laps, "--laps")
    _check_name(options.name)
    check_planner_options(options)
    planners = [*planners_of(options.planner, options), *ros2_planners(options.ros2, options)]
    planners = planners or [Driver.short_forms()["race"]]
    description = options.description and file_option(options.description)
    wanted = Race(options.place, options.laps, planners, options.timeout, description, options.name)
    plan = plan_race(wanted, results_of(options) / wanted.name, options.set)
    if options.repeat is not None:
        return _repeat(wanted, options)
    if options.save:
        _save(wanted, options.save)
        return PASSED
    plan = dataclasses.replace(plan, keep_bag=options.bag, watched=options.attach)
    return with_report(run_plan(plan), options)


def _repeat(wanted: Race, options) -> int:
    check_repeat(options)
    file = results_of(options) / "repeat" / f"{wanted.name}.yaml"
    with writing(file):
        file.parent.mkdir(parents=True, exist_ok=True)
    _save(wanted, file)
    return run_repeatedly(str(file), options, options.set)


def _save(wanted: Race, file: Path) -> None:
    with writing(file), replacing(file) as temporary:
        temporary.write_text(race_text(wanted, file.parent), encoding="utf-8")


def _check_name(name: Optional[str]) -> None:
    if name is not None and not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_.-]*", name):
        rule = "must begin with a letter or a digit and have only those and '_', '-' and '.'"
        raise ScenarioError(f"--name {name}: {rule}")
