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

