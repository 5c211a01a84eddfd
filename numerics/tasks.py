"""Independent tasks: in turn, or in processes by joblib."""

from __future__ import annotations

import os
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing
from typing import TypeVar
from warnings import catch_warnings

from numerics.errors import MissingTool


def available_cores() -> int:
    """Return how many cores this process may use."""
    allowed = getattr(os, "sched_getaffinity", None)  # Linux only
    return len(allowed(0)) if allowed else os.cpu_count() or 1


Task = TypeVar("Task")
Result = TypeVar("Result")


def run_tasks(
    function: Callable[[Task], Result],
    tasks: Sequence[Task],
    *,
    jobs: int = 1,
    progress: Callable[[int, int], None] | None = None,
) -> Iterator[Result]:
    """Yield function(task) for every task, in their order; the same function in `jobs` processes as in one.

    `progress` takes how many are done, and of how many. Raises MissingTool if joblib (jobs > 1) is not installed.
    """
    here = (function(task) for task in tasks)
    with closing(_in_processes(function, tasks, jobs) if jobs > 1 else here) as results:
        for done, result in enumerate(results, start=1):
            yield result
            if progress is not None:
                progress(done, len(tasks))


def _in_processes(function: Callable[[Task], Result], tasks: Sequence[Task], jobs: int) -> Generator[Result]:
    try:
        from joblib import Parallel, delayed
    except ImportError:
        raise MissingTool("more than one job needs joblib: pip install 'inertial-pair[parallel]'") from None
    found = Parallel(n_jobs=jobs, return_as="generator", batch_size=1)(delayed(function)(task) for task in tasks)
    try:
        for result in found:  # noqa: UP028 - `yield from` would close it, which warns of what nobody took
            yield result
    finally:
        with catch_warnings(action="ignore"):
            found.close()
