"""Jobs on the machines of a Dask cluster."""

import contextlib
import time
from collections.abc import Iterator, Sequence

from f1tenth_judge.batch.jobs import Job, Outcome, run_job
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.stop_request import StopRequest

_CONNECT_TIMEOUT = 10.0  # wall s
_LOOK_INTERVAL = 0.2  # wall s


def run_on_cluster(jobs: Sequence[Job], stop: StopRequest, scheduler: str) -> Iterator[Outcome]:
    """Run jobs on a cluster and yield their outcomes; a job of a worker that dies is run again.

    Args:
        jobs: what to run; workspace and results folder are at the same place on all machines
        stop: once it has a signal, what has not begun is left out
        scheduler: address, as in tcp://host:8786

    Raises:
        ScenarioError: the scheduler cannot be reached.
    """
    with _connected(scheduler) as client:
        waiting = {client.submit(run_job, job, pure=False): job for job in jobs}
        while waiting and not stop.signal:
            for future in [each for each in waiting if each.done()]:
                yield _outcome(future, waiting.pop(future))
            time.sleep(_LOOK_INTERVAL)
        client.cancel(list(waiting))


def _outcome(future, job: Job) -> Outcome:
    error = future.exception()
    return future.result() if error is None else Outcome(job, 1, str(error), None)


@contextlib.contextmanager
def _connected(scheduler: str) -> Iterator:
    if "://" not in scheduler:
        # Dask would look for a host of that name, and not end cleanly when there is none.
        raise ScenarioError(f"--scheduler {scheduler}: must be an address, as in tcp://host:8786")
    # Imported late: it takes longer than everything else that the command does, and races go without it.
    try:
        from distributed import Client
    except ImportError as error:
        raise ScenarioError(
            "--scheduler needs the Python package distributed (make setup installs it)"
        ) from error
    try:
        client = Client(scheduler, set_as_default=False, timeout=_CONNECT_TIMEOUT)
    except (OSError, ValueError) as error:
        raise ScenarioError(f"--scheduler {scheduler}: {' '.join(str(error).split())}") from error
    with client:
        yield client
