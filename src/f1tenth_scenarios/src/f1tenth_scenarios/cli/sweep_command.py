"""scenario sweep."""

from f1tenth_scenarios.cli.exit_codes import exit_code
from f1tenth_scenarios.cli.options import results_of
from f1tenth_scenarios.errors import ScenarioError
from f1tenth_scenarios.stop_request import StopRequest


def sweep(options) -> int:
    """Run many variations of a scenario."""
    from f1tenth_scenarios.batch.sweep import sweep as run_sweep

    if options.workers is not None and options.workers < 1:
        raise ScenarioError(f"--workers is {options.workers}, must be at least 1")
    output = options.output.resolve() if options.output else None
    with StopRequest().listening() as stop:
        complete = run_sweep(
            options.name, options.vary, results_of(options), stop, options.workers, options.scheduler, output
        )
    return exit_code(complete, stop)
