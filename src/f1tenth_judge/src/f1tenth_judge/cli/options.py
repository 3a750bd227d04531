"""What several subcommands make of their options."""

import dataclasses
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.driver_file import driver_file
from f1tenth_judge.plan.named_planner import named_planner
from f1tenth_judge.plan.planner import planner_setting
from f1tenth_judge.scenario.driver import Driver, Interface
from f1tenth_judge.suites.suite import seeds


def results_of(options) -> Path:
    """The folder of all results."""
    return (options.results or lookup.results_root()).resolve()


def expect_at_least(least: int, number: Optional[int], option: str) -> None:
    """Refuse a number that makes no sense before the work begins.

    Raises:
        ScenarioError: the number that an option was given is less.
    """
    if number is not None and number < least:
        raise ScenarioError(f"{option} is {number}, must be at least {least}")


def check_name(name: Optional[str]) -> None:
    """Refuse a name that no results folder can have.

    Raises:
        ScenarioError: which characters it may have.
    """
    if name is not None and not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_.=,+-]*", name):
        rule = "must begin with a letter or a digit and have only those and '_.=,+-'"
        raise ScenarioError(f"--name {name}: {rule}")


def seed_settings(options) -> list[tuple[str, ...]]:
    """The settings of each of the --seeds; without them the one run that has none.

    Raises:
        ScenarioError: one is not a whole number.
    """
    return [(f"seed={each}",) for each in seeds(options.seeds, "--seeds")] if options.seeds else [()]


def check_planner_options(options) -> None:
    """Refuse options of a planner where none is named: they would change nothing.

    Raises:
        ScenarioError: --arg or --interface without --planner.
    """
    if not (options.planner or options.ros2) and (options.arg or options.interface != Interface.NATIVE.value):
        raise ScenarioError(f"{'--arg' if options.arg else '--interface'} is for a --planner")


def planner_settings(options) -> list[str]:
    """The setting for the one planner that options name; empty if they name none.

    Raises:
        ScenarioError: as planners_named.
    """
    return [planner_setting(planner) for planner in planners_named(options)]


def planners_named(options) -> list[Driver]:
    """The one planner that options name; none if they name none.

    Raises:
        ScenarioError: two are named, or as planner_of.
    """
    check_planner_options(options)
    if options.planner and options.ros2:
        raise ScenarioError("--ros2 is given beside --planner; one planner drives in all scenarios")
    planners = ros2_planners([options.ros2], options) if options.ros2 else []
    return planners + ([planner_of(options.planner, options)] if options.planner else [])


def ros2_planners(commands: Sequence[str], options) -> list[Driver]:
    """The planners of ROS 2 that options name, each with all --arg.

    Raises:
        ScenarioError: --interface, or an --arg that is not of its form.
    """
    if commands and Interface(options.interface) not in (Interface.NATIVE, Interface.F1TENTH_GYM_ROS):
        raise ScenarioError(
            "--interface is for a --planner; with --ros2 the topics are those of f1tenth_gym_ros"
        )
    arguments = dict(_argument(text) for text in options.arg)
    return [Driver(ros2=command, arguments=arguments) for command in commands]


def planner_of(name: str, options) -> Driver:
    """A planner as an option names it.

    Raises:
        ScenarioError: there is no such file, or --arg is not of its form.
    """
    arguments = dict(_argument(text) for text in options.arg)
    try:
        return named_planner(name, Path.cwd(), Interface(options.interface), arguments)
    except ScenarioError as error:
        raise ScenarioError(f"--planner {error}") from error


def planners_of(names: Sequence[str], options) -> list[Driver]:
    """The planners of a race; each gets the --arg that it knows. One that none knows is left to be refused.

    Raises:
        ScenarioError: as planner_of.
    """
    planners = [planner_of(name, options) for name in names]
    known = [driver_file(each, Path.cwd()).arguments for each in planners]
    given = {name for each in planners for name in each.arguments}
    nowhere = given.difference(*known)
    return [
        dataclasses.replace(each, arguments={k: v for k, v in each.arguments.items() if k in own | nowhere})
        for each, own in zip(planners, known)
    ]


def _argument(text: str) -> tuple[str, str]:
    name, assigns, value = text.partition(":=")
    if not (name and assigns):
        raise ScenarioError(f"--arg {text}: must be NAME:=VALUE, as in speed:=4.0")
    # What a scenario file anywhere would name.
    return name, value if value.startswith("package://") else lookup.file_or_text(value, Path.cwd())
