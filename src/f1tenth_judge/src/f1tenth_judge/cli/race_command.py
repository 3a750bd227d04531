"""f1tenth race."""

import dataclasses
from pathlib import Path

from f1tenth_judge.cli.exit_codes import PASSED
from f1tenth_judge.cli.options import (
    check_name,
    check_planner_options,
    expect_at_least,
    planners_of,
    results_of,
    ros2_planners,
)
from f1tenth_judge.cli.run_command import check_repeat, run_each, run_repeatedly, run_with_report
from f1tenth_judge.errors import writing
from f1tenth_judge.plan.named_planner import named_file
from f1tenth_judge.plan.race import Race, plan_race, save_race
from f1tenth_judge.scenario.driver import Driver


def race(options) -> int:
    """Run and judge a race that is in no scenario file."""
    expect_at_least(1, options.laps, "--laps")
    expect_at_least(1, options.workers, "--jobs")
    check_name(options.name)
    check_planner_options(options)
    planners = [*planners_of(options.planner, options), *ros2_planners(options.ros2, options)]
    planners = planners or [Driver.short_forms()["race"]]
    description = options.description and named_file(options.description, Path.cwd())
    wanted = Race(options.place, options.laps, planners, options.timeout, description, options.name)
    plan = plan_race(wanted, results_of(options) / wanted.name, options.set)
    if options.repeat is not None or options.seeds:
        return _several(wanted, options)
    if options.save:
        save_race(wanted, options.save)
        return PASSED
    plan = dataclasses.replace(plan, keep_bag=options.bag, watched=options.attach)
    return run_with_report(plan, options)


def _several(wanted: Race, options) -> int:
    file = results_of(options) / "races" / f"{wanted.name}.yaml"
    if options.repeat is not None:
        check_repeat(options)
    with writing(file):
        file.parent.mkdir(parents=True, exist_ok=True)
    save_race(wanted, file)
    if options.repeat is not None:
        return run_repeatedly(str(file), options, options.set)
    return run_each([str(file)], options.set, options)
