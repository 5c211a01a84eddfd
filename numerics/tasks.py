"""Independent tasks: in turn, in processes by joblib, or on a Dask cluster; results come as they finish."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from numerics.errors import MissingTool


def available_cores() -> int:
    """Return how many cores this process may use."""
    allowed = getattr(os, "sched_getaffinity", None)  # Linux only
    return len(allowed(0)) if allowed else os.cpu_count() or 1


Task = TypeVar("Task")
Result = TypeVar("Result")


def run_tasks(
    function: Callable[[Task], Result], tasks: Sequence[Task], *, jobs: int = 1, dask: str | None = None
) -> Iterator[Result]:
    """Yield function(task) for every task, in any order; the same function on every road.

    A worker that is killed loses nothing: what it held is done by another one. Raises MissingTool if joblib (jobs > 1)
    or distributed (dask, the address of a scheduler) is not installed.
    """
    if dask is not None:
        yield from _on_cluster(function, tasks, dask)
    elif jobs > 1:
        yield from _in_processes(function, tasks, jobs)
    else:
        yield from map(function, tasks)


def _in_processes(function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int) -> Iterator[Result]:
    try:
        from joblib import Parallel, delayed
        from joblib.externals.loky.process_executor import TerminatedWorkerError
    except ImportError:
        raise MissingTool("more than one job needs joblib: pip install 'inertial-pair[maps]'") from None
    waiting = dict(enumerate(tasks))
    while waiting:
        before, workers = len(waiting), Parallel(n_jobs=jobs, return_as="generator_unordered", batch_size=1)
        try:
            for index, result in workers(delayed(_numbered)(function, *one) for one in list(waiting.items())):
                del waiting[index]
                yield result
        except TerminatedWorkerError:  # what it held is done again, unless nothing gets done at all
            if len(waiting) == before:
                raise


def _numbered(function: Callable[[Task], Result], index: int, task: Task) -> tuple[int, Result]:
    return index, function(task)


def _on_cluster(function: Callable[[Task], Result], tasks: Sequence[Task], address: str) -> Iterator[Result]:
    try:
        from distributed import Client, as_completed
    except ImportError:
        raise MissingTool("a Dask cluster needs distributed: pip install 'inertial-pair[dask]'") from None
    try:
        client = Client(address, timeout="10s")
    except (OSError, ValueError) as error:
        raise MissingTool(f"no Dask scheduler answers at {address}: {error}") from None
    with client:
        for future in as_completed(client.map(function, tasks)):
            yield future.result()
