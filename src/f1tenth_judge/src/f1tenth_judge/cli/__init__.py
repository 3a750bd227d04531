"""The command `f1tenth`: race, run, list, suite, compare, report, verify and more."""

import os
import signal
import sys
from collections.abc import Sequence
from typing import Optional

from f1tenth_judge.cli.exit_codes import BAD_INPUT
from f1tenth_judge.cli.parser import make_parser
from f1tenth_judge.cli.standard_streams import open_standard_streams
from f1tenth_judge.errors import ScenarioError, as_typed
from f1tenth_judge.extensions import extensions
from f1tenth_judge.places import lookup
from f1tenth_judge.run.ros import GROUP


def main(arguments: Optional[Sequence[str]] = None, program: str = "f1tenth") -> int:
    """Run the command, which is called `program`; returns the exit code."""
    open_standard_streams()
    # Loaded first, because with ROS packages are found where ROS finds them.
    extensions(GROUP)
    options = make_parser(program).parse_args(arguments)
    if "command" in options:
        return main([*options.command, "--watch"], program)
    for folder in filter(None, (options.path, options.search_path)):
        lookup.add_search_path(folder)
    try:
        return options.action(options)
    except ScenarioError as error:
        print(f"{program}: {as_typed(str(error))}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        return 128 + signal.SIGINT
    except BrokenPipeError:  # as in `f1tenth list | head -1`
        # What is left in the buffer would be the next broken pipe.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 128 + signal.SIGPIPE
