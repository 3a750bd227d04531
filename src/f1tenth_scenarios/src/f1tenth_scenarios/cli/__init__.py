"""The command `scenario`: list, check, run, race, sweep, compare, report, keys."""

import os
import signal
import sys
from collections.abc import Sequence
from typing import Optional

from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import lookup

from f1tenth_scenarios.cli.exit_codes import BAD_INPUT
from f1tenth_scenarios.cli.parser import make_parser


def main(arguments: Optional[Sequence[str]] = None, program: str = "scenario") -> int:
    """Run the command, which is called `program`; returns the exit code."""
    options = make_parser(program).parse_args(arguments)
    for folder in filter(None, (options.path, options.search_path)):
        lookup.add_search_path(folder)
    try:
        return options.action(options)
    except ScenarioError as error:
        print(f"{program}: {error}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        return 128 + signal.SIGINT
    except BrokenPipeError:  # as in `scenario list | head -1`
        # What is left in the buffer would be the next broken pipe.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 128 + signal.SIGPIPE
