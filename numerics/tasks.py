"""Independent tasks: in turn, in processes by joblib, or on a Dask cluster; results come as they finish."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from typing import Any, TypeVar

from numerics.errors import MissingTool


def available_cores() -> int:
    """Return how many cores this process may use."""
    allowed = getattr(os, "sched_getaffinity", None)  # Linux only
    return len(allowed(0)) if allowed else os.cpu_count() or 1


Task = TypeVar("Task", bound=tuple[Any, ...])
Result = TypeVar("Result", bound=tuple[Any, ...])


def run_tasks(
    function: Callable[[Task], Result], tasks: Sequence[Task], *, jobs: int = 1, dask: str | None = None
) -> Iterator[Result]:
    """Yield function(task) for every task, in any order; the same function on every road.

    A task begins with its number, and so does what comes of it.
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
    waiting = {task[0]: task for task in tasks}
    while waiting:
        before, workers = len(waiting), Parallel(n_jobs=jobs, return_as="generator_unordered", batch_size=1)
        try:
            for result in workers(delayed(function)(task) for task in list(waiting.values())):
                del waiting[result[0]]
                yield result
        except TerminatedWorkerError:  # what it held is done again, unless nothing gets done at all
            if len(waiting) == before:
                raise


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
