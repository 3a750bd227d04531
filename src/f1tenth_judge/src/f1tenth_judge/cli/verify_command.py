"""f1tenth verify."""

from pathlib import Path
from typing import Any

from f1tenth_judge.cli.exit_codes import NOT_PASSED, PASSED
from f1tenth_judge.cli.options import results_of
from f1tenth_judge.cli.run_command import run_plan
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.plan.planning import make_plan
from f1tenth_judge.record.files import RESULT_FILE
from f1tenth_judge.results.result_file import read_result


def verify(options) -> int:
    """Run the scenario of a result again, and compare the trajectories."""
    file = options.result / RESULT_FILE if options.result.is_dir() else options.result
    wanted = _result(file)
    name = options.scenario or wanted["scenario"]
    folder = results_of(options) / "verify" / wanted["scenario"]
    plan = make_plan(name, folder, [*wanted["settings"], f"seed={wanted['seed']}"])
    code = run_plan(plan)
    if code not in (PASSED, NOT_PASSED):
        return code
    found = _result(folder / RESULT_FILE)
    same = found["trajectory_hash"] == wanted["trajectory_hash"]
    print(_comparison(wanted, found, same))
    return PASSED if same else NOT_PASSED


def _result(file: Path) -> dict[str, Any]:
    result = read_result(file)
    if result["machine"] is None:
        raise ScenarioError(f"{file}: is of an episode, not of a scenario that could be run again")
    if not result["lockstep"]:
        raise ScenarioError(f"{file}: this run was not in lockstep, so that no other one can be like it")
    return result


def _comparison(wanted: dict[str, Any], found: dict[str, Any], same: bool) -> str:
    if same:
        return f"the same trajectory: {found['trajectory_hash']}"
    lines = [f"another trajectory: {found['trajectory_hash']}, not {wanted['trajectory_hash']}"]
    for key in sorted({*wanted["machine"], *found["machine"]}):
        before, now = wanted["machine"].get(key), found["machine"].get(key)
        if before != now:
            lines.append(f"  {key}: {now}, not {before}")
    return "\n".join(lines)
