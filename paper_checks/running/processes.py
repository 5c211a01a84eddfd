"""Tasks in several processes (concurrent.futures): rows are decided so, figures drawn."""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import resource_tracker
from typing import Any, TypeVar

Task = TypeVar("Task")
Answer = Callable[[Any, Any], object]
"""What runs in a process, a function of a module: of a task, and of what is given for all."""


class Ended:
    """What stands for an answer where the process ended without one."""


def answers(tasks: Sequence[Task], jobs: int, answer: Answer, given: object) -> Iterator[tuple[Task, Any]]:
    """Yield each task and its answer, or that its process has `Ended`, as soon as that is there, in any order.

    Tasks are begun in their order. Where a process ends, the tasks that have no answer yet are given one process each.
    What a task raises is raised here; whatever ends the loop, an interrupt among it, ends the processes.
    """
    lost: list[Task] = []
    with _pool(min(jobs, len(tasks))) as pool:
        with _unheard():
            waiting = {pool.submit(answer, task, given): task for task in tasks}
        for future in as_completed(waiting):
            try:
                yield waiting[future], future.result()
            except BrokenProcessPool:
                if len(tasks) == 1:
                    yield tasks[0], Ended()
                else:
                    lost.append(waiting[future])
    for task in lost:
        yield from answers([task], 1, answer, given)


@contextmanager
def _pool(jobs: int) -> Iterator[ProcessPoolExecutor]:
    """Yield a pool whose processes end with the block, whatever they are at."""
    others = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(jobs, multiprocessing.get_context("spawn"))
    try:
        yield pool
    finally:
        for process in set(multiprocessing.active_children()) - others:
            process.terminate()
        pool.shutdown(cancel_futures=True)


@contextmanager
def _unheard() -> Iterator[None]:
    """Let processes that are started here never hear Ctrl-C, where the system can block it: this one ends them."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # it would be started in here, and unblocks signals when it is
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
