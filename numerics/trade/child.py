"""The parent's end of a worker: ask, wait no longer than the limit, end it with everything it has started."""

from __future__ import annotations

import contextlib
import json
import os
import queue
import signal
import subprocess
import sys
import tempfile
import threading
import time
from types import TracebackType
from typing import Any


class Hung(Exception):
    """Nothing came within the limit."""


class Died(Exception):
    """The worker ended by itself; the message says how."""


class Child:
    """A worker process, started when it is first asked and started again after it was ended."""

    def __init__(self) -> None:
        """Start nothing yet."""
        self._process: subprocess.Popen[str] | None = None
        self._answers: queue.Queue[dict[str, Any] | None] = queue.Queue()
        self._complaints = tempfile.TemporaryFile()  # noqa: SIM115 - closed by __exit__

    def __enter__(self) -> Child:
        """Return the child."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End the worker, whatever it does."""
        self.end()
        self._complaints.close()

    def ask(self, request: dict[str, Any]) -> None:
        """Send a request."""
        if self._process is None:
            self._start()
        process = self._process
        if process is None or process.stdin is None:
            raise Died("it did not start")
        with contextlib.suppress(BrokenPipeError):  # that it died is told by `answer`
            process.stdin.write(json.dumps(request) + "\n")
            process.stdin.flush()

    def answer(self, limit: float) -> dict[str, Any]:
        """Return the next answer. Raises Hung after `limit` s and Died if there will be none; the worker is ended."""
        try:
            answer = self._answers.get(timeout=max(0.0, limit))
        except queue.Empty:
            self.end()
            raise Hung from None
        if answer is None:
            raise Died(self._obituary())
        return answer

    def end(self) -> None:
        """Kill the worker and what it has started; it leads a process group of its own."""
        process, self._process = self._process, None
        if process is None:
            return
        with contextlib.suppress(ProcessLookupError):
            if hasattr(os, "killpg"):
                os.killpg(process.pid, signal.SIGKILL)
            else:  # Windows knows no groups: the worker alone
                process.kill()
        process.wait()
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                with contextlib.suppress(BrokenPipeError):
                    pipe.close()

    def _start(self) -> None:
        self._complaints.seek(0)
        self._complaints.truncate()
        self._process = subprocess.Popen(
            [sys.executable, "-m", "numerics.trade.worker"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._complaints,
            encoding="utf-8",
            start_new_session=True,
        )
        self._answers = queue.Queue()
        threading.Thread(target=_forward, args=(self._process.stdout, self._answers), daemon=True).start()

    def _obituary(self) -> str:
        """Return how the worker ended: the signal, or its exit code, and the last thing it complained of."""
        code = 0 if self._process is None else self._process.wait()
        self.end()
        how = f"killed by signal {-code} ({signal.Signals(-code).name})" if code < 0 else f"ended with code {code}"
        self._complaints.seek(0)
        lines = [line for line in self._complaints.read().decode("utf-8", "replace").splitlines() if line.strip()]
        return f"{how}: {lines[-1].strip()[:200]}" if lines else how


def _forward(lines: Any, answers: queue.Queue[dict[str, Any] | None]) -> None:
    """Put every line of a worker into a queue, and None after the last."""
    with contextlib.suppress(ValueError):  # the pipe was closed under the thread
        for line in lines:
            answers.put(json.loads(line))
    answers.put(None)


class Deadline:
    """The time that is left of a limit."""

    def __init__(self, seconds: float) -> None:
        """Start now."""
        self._end = time.monotonic() + seconds

    def left(self) -> float:
        """Return the seconds that are left, 0 if none."""
        return max(0.0, self._end - time.monotonic())
