"""Rows in parallel: processes that load the checks once and are given one claim at a time.

A process that ends without an answer costs its own row only, which is undecided, and another takes its place.
"""

from __future__ import annotations

import multiprocessing
import pkgutil
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from multiprocessing.connection import Connection, wait
from typing import Any

from paper_checks import checks
from paper_checks.checks.registry import Context, load_checks
from paper_checks.ledger import Claim, claim_named
from paper_checks.running.plain import Plain, plain
from paper_checks.running.runner import Row, failed, run

SHARING = (
    "section3_near_critical",
    "section3_convergence",
    "section3_itineraries",
    "theorems_return_map",
    "theorems_rate",
    "theorems_uniform",
    "theorems_excursion",
    "theorems_share",
    "theorems_merging",
)
"""Checks that derive the same long series, which a process then has: they stand together, at the front."""


def method() -> Any:
    """Return how processes are started: from one that has loaded the checks, where the system can; else each anew."""
    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    modules = pkgutil.iter_modules(checks.__path__)
    context.set_forkserver_preload([f"{checks.__name__}.{one.name}" for one in modules])
    return context


def begin() -> None:
    """Let the process that the others are started from load the checks, while this one does something else."""
    if method().get_start_method() == "forkserver":
        from multiprocessing.forkserver import ensure_running  # there is none on Windows

        with _deaf():
            ensure_running()


@contextmanager
def _deaf() -> Iterator[None]:
    """Let a process that is started here ignore Ctrl-C from its first moment: while it loads the checks, it has no word.

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


def found(
    claims: Sequence[Claim], context: Context, jobs: int, serve: Callable[[Connection, Context], None] | None = None
) -> Iterator[Row | Plain]:
    """Decide the claims in `jobs` processes, and yield each as soon as it is found, in any order.

    Whatever ends the loop, an interrupt among it, ends the processes. `serve` is what runs in each of them.
    """
    serve = serve or _serve
    free = [_Process(serve, context, at_front=not number) for number in range(min(jobs, len(claims)))]
    waiting = deque(sorted(claims, key=_place))
    busy: dict[Connection, tuple[_Process, Claim]] = {}
    try:
        while waiting or busy:
            while waiting and free:
                process = free.pop()
                claim = waiting.popleft() if process.at_front else waiting.pop()
                process.connection.send(claim.id)
                busy[process.connection] = process, claim
            for connection in wait(list(busy)):
                process, claim = busy[connection]  # type: ignore[index]
                try:
                    answer = process.connection.recv()
                except (EOFError, OSError):
                    answer = Row(claim, failed(RuntimeError(f"its process ended with exit code {process.end()}")))
                    process = _Process(serve, context, process.at_front)
                del busy[connection]  # type: ignore[arg-type]
                free.append(process)
                yield answer
    finally:
        for process in [*free, *(one for one, _ in busy.values())]:
            process.end()


def _place(claim: Claim) -> int:
    """Return where a claim stands among those that wait; claims in the same place keep the ledger's order."""
    modules = [check.__module__.rpartition(".")[2] for check in load_checks().of(claim.id)]
    return next((SHARING.index(module) for module in modules if module in SHARING), len(SHARING))


class _Process:
    """One process, and our end of the pipe to it."""

    def __init__(self, serve: Callable[[Connection, Context], None], context: Context, at_front: bool) -> None:
        """Start it; it takes claims from the front of those that wait, or from the back."""
        self.at_front = at_front
        started = method()
        self.connection, theirs = started.Pipe()
        self._process = started.Process(target=serve, args=(theirs, context), daemon=True)
        if started.get_start_method() == "forkserver":
            begin()  # what is forked off it does not hear Ctrl-C either
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


def _serve(connection: Connection, context: Context) -> None:
    """Decide the claims that come by the connection, until it is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches all; the process that asks for rows ends this one
    registry = load_checks()
    while True:
        try:
            name = connection.recv()
        except EOFError:
            return
        connection.send(plain(run([claim_named(name)], registry, context)[0]))
