"""scenario sweep."""

from f1tenth_scenarios.cli.exit_codes import exit_code
from f1tenth_scenarios.cli.options import expect_at_least, results_of
from f1tenth_scenarios.stop_request import StopRequest


def sweep(options) -> int:
    """Run many variations of a scenario."""
    from f1tenth_scenarios.batch.sweep import sweep as run_sweep

    expect_at_least(1, options.workers, "--workers")
    output = options.output.resolve() if options.output else None
    with StopRequest().listening() as stop:
        complete = run_sweep(
            options.name, options.vary, results_of(options), stop, options.workers, options.scheduler, output
        )
    return exit_code(complete, stop)
