"""Many variations of a scenario, in parallel on Dask: on the local cores, or on a cluster."""

import contextlib
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Callable, Optional

from f1tenth_scenarios.batch.batch import Job, read_finished, run_job
from f1tenth_scenarios.errors import ScenarioError

Finished = Callable[[Job, dict[str, Any]], None]
_CONNECT_TIMEOUT = 10.0  # wall s, to reach a scheduler


def run_jobs(
    jobs: Sequence[Job],
    program: str,
    finished: Finished,
    workers: Optional[int] = None,
    scheduler: Optional[str] = None,
) -> list[str]:
    """Run all jobs that have not been run yet.

    A worker that dies is replaced, and what it was running is run again.

    Args:
        jobs: what to run
        program: path of the command `scenario`, the same on all machines
        finished: is called for each job with its result, also for one that had been run before
        workers: local processes; default: one a core
        scheduler: address of a Dask scheduler to use instead, as in tcp://host:8786

    Returns:
        What went wrong: a line for each job without result.

    Raises:
        ScenarioError: the scheduler cannot be reached.
    """
    left = []
    for job in jobs:
        result = read_finished(job)
        if result is None:
            left.append(job)
        else:
            finished(job, result)
    if not left:
        return []
    with _client(workers, scheduler) as client:
        return list(_run(client, left, program, finished))


def _run(client, jobs: Iterable[Job], program: str, finished: Finished) -> Iterator[str]:
    from distributed import as_completed

    futures = {client.submit(run_job, job, program, pure=False): job for job in jobs}
    for future in as_completed(futures, loop=client.loop):
        error = future.exception()
        if error is None:
            finished(futures[future], future.result())
        else:
            yield f"{futures[future].folder}: {error}"


@contextlib.contextmanager
def _client(workers: Optional[int], scheduler: Optional[str]):
    # Imported late: it takes longer than everything else that the command does.
    from distributed import Client, LocalCluster

    if scheduler:
        try:
            client = Client(scheduler, set_as_default=False, timeout=_CONNECT_TIMEOUT)
        except (OSError, ValueError) as error:
            raise ScenarioError(f"--scheduler {scheduler}: {' '.join(str(error).split())}") from error
        with client:
            yield client
        return
    options = {"threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with (
        LocalCluster(n_workers=workers, **options) as cluster,
        Client(cluster, set_as_default=False) as client,
    ):
        yield client
