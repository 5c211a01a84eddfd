"""Tasks in several processes (concurrent.futures), each of which is given one at a time: rows are decided so, figures drawn.

A process that ends without an answer costs its own task only, and another takes its place: each is a pool of one.
"""

from __future__ import annotations

import multiprocessing
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import resource_tracker
from typing import Any, TypeVar

Task = TypeVar("Task")
Answer = Callable[[Any, Any], object]
"""What runs in a process, a function of a module: of a task, and of what is given for all."""


@dataclass(frozen=True)
class Ended:
    """What stands for an answer where the process ended without one."""

    exit_code: int | None


def method() -> Any:
    """Return how processes are started: from one that has loaded what they need, where the system can; else each anew."""
    can = "forkserver" in multiprocessing.get_all_start_methods()
    return multiprocessing.get_context("forkserver" if can else "spawn")


def begin(modules: Sequence[str]) -> None:
    """Let the process that the others are started from load modules, while this one does something else.

    There is one such process: where it runs already, the others load what it lacks themselves.
    """
    context = method()
    if context.get_start_method() == "forkserver":
        from multiprocessing.forkserver import ensure_running  # there is none on Windows

        context.set_forkserver_preload(list(modules))
        with _put_off():
            ensure_running()


@contextmanager
def _put_off() -> Iterator[None]:
    """Put Ctrl-C off until the end, and let a process that is started here never hear it: this one ends it.

    A signal that is blocked is blocked in what is started, too (where the system can block one), from its first moment.
    """
    blocks = hasattr(signal, "pthread_sigmask")
    if blocks:
        resource_tracker.ensure_running()  # it would be started in here, and unblocks signals when it is
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    heard: list[int] = []  # another thread, numpy's, say, may be given the signal all the same
    main = threading.current_thread() is threading.main_thread()  # another one may not say what a signal does
    before = signal.signal(signal.SIGINT, lambda number, _: heard.append(number)) if main else None
    try:
        yield
    finally:
        if main:
            signal.signal(signal.SIGINT, before or signal.SIG_DFL)
        if blocks:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        if heard:
            signal.raise_signal(signal.SIGINT)


def answers(tasks: Sequence[Task], jobs: int, answer: Answer, given: object) -> Iterator[tuple[Task, Any]]:
    """Yield each task and its answer, or that its process has `Ended`, as soon as that is there, in any order.

    One of the `jobs` processes takes tasks from the front, the others from the back. What a task raises is raised here;
    whatever ends the loop, an interrupt among it, ends the processes.
    """
    begin([answer.__module__])
    free = [_Process(at_front=not number) for number in range(min(jobs, len(tasks)))]
    waiting, busy = deque(tasks), dict[Future[object], tuple[_Process, Task]]()
    try:
        while waiting or busy:
            while waiting and free:
                process = free.pop()
                task = waiting.popleft() if process.at_front else waiting.pop()
                busy[process.submit(answer, task, given)] = process, task
            for future in wait(busy, return_when=FIRST_COMPLETED).done:
                process, task = busy[future]
                try:
                    found = future.result()
                except BrokenProcessPool:
                    found = Ended(process.end())
                    process = _Process(process.at_front)
                del busy[future]
                free.append(process)
                yield task, found
    finally:
        for process in [*free, *(one for one, _ in busy.values())]:
            process.end()


class _Process:
    """A pool of one process, which starts with its first task and does not hear Ctrl-C: it reaches all, and this one ends it."""

    def __init__(self, at_front: bool) -> None:
        """Make the pool; it takes tasks from the front of those that wait, or from the back."""
        self.at_front = at_front
        self._pool = ProcessPoolExecutor(1, method())
        self._process: Any = None

    def submit(self, answer: Answer, task: object, given: object) -> Future[object]:
        """Give it a task."""
        if self._process is not None:
            return self._pool.submit(answer, task, given)
        others = set(multiprocessing.active_children())
        with _put_off():
            future = self._pool.submit(answer, task, given)
            self._process = next(iter(set(multiprocessing.active_children()) - others), None)
        return future

    def end(self) -> int | None:
        """End it, at once, and return its exit code; None where it has not begun."""
        if self._process is not None:
            self._process.terminate()
        self._pool.shutdown(cancel_futures=True)
        return None if self._process is None else self._process.exitcode
