"""Tasks in several processes, each of which is given one at a time: rows are decided so, figures drawn.

A process that ends without an answer costs its own task only, and another takes its place.
"""

from __future__ import annotations

import multiprocessing
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from typing import Any, TypeVar

Task = TypeVar("Task")
Serve = Callable[[Connection, Any], None]
"""What runs in a process: it answers what comes by the connection, until that is closed."""


@dataclass(frozen=True)
class Ended:
    """What stands for an answer where the process ended without one."""

    exit_code: int


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
        context.set_forkserver_preload(list(modules))
        _start_from()


def _start_from() -> None:
    """Start the process that the others are started from, where none runs."""
    from multiprocessing.forkserver import ensure_running  # there is none on Windows

    with _deaf():
        ensure_running()


@contextmanager
def _deaf() -> Iterator[None]:
    """Let a process that is started here ignore Ctrl-C from its first moment: while it loads modules, it has no word.

    It inherits that from this one, which ends it; so this one does not hear Ctrl-C for the milliseconds that starting takes.
    """
    if threading.current_thread() is not threading.main_thread():  # another one may not say what a signal does
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before or signal.SIG_DFL)


def answers(tasks: Sequence[Task], jobs: int, serve: Serve, given: object) -> Iterator[tuple[Task, Any]]:
    """Yield each task and its answer, or that its process has `Ended`, as soon as that is there, in any order.

    `serve` runs with `given` in each of the `jobs` processes. One takes tasks from the front, the others from the back.
    Whatever ends the loop, an interrupt among it, ends the processes.
    """
    free = [_Process(serve, given, at_front=not number) for number in range(min(jobs, len(tasks)))]
    waiting = deque(tasks)
    busy: dict[Connection, tuple[_Process, Task]] = {}
    try:
        while waiting or busy:
            while waiting and free:
                process = free.pop()
                task = waiting.popleft() if process.at_front else waiting.pop()
                process.connection.send(task)
                busy[process.connection] = process, task
            for connection in wait(list(busy)):
                process, task = busy[connection]  # type: ignore[index]
                try:
                    answer = process.connection.recv()
                except (EOFError, OSError):
                    answer = Ended(process.end())
                    process = _Process(serve, given, process.at_front)
                del busy[connection]  # type: ignore[arg-type]
                free.append(process)
                yield task, answer
    finally:
        for process in [*free, *(one for one, _ in busy.values())]:
            process.end()


def serve_each(connection: Connection, answer: Callable[[Any], object]) -> None:
    """Answer the tasks that come by the connection, until it is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches all; the process that asks ends this one
    while True:
        try:
            task = connection.recv()
        except EOFError:
            return
        connection.send(answer(task))


class _Process:
    """One process, and our end of the pipe to it."""

    def __init__(self, serve: Serve, given: object, at_front: bool) -> None:
        """Start it; it takes tasks from the front of those that wait, or from the back."""
        self.at_front = at_front
        started = method()
        self.connection, theirs = started.Pipe()
        self._process = started.Process(target=serve, args=(theirs, given), daemon=True)
        if started.get_start_method() == "forkserver":
            _start_from()  # what is forked off it does not hear Ctrl-C either
            self._process.start()
        else:
            with _deaf():
                self._process.start()
        theirs.close()

    def end(self) -> int:
        """End it, at once, and return its exit code."""
        self.connection.close()
        self._process.join(0.1)
        self._process.terminate()
        self._process.join()
        return int(self._process.exitcode)
