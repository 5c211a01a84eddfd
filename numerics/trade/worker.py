"""The child process in which contenders run: one JSON line asks for a run, several answer, stage by stage.

A request is {"source", "contender", "scene", "setting", "budget"}. The answers are {"stage": "prepared", "seconds"},
{"stage": "ran", "seconds", "outcome"}, {"stage": "timed", "seconds", "batches"}, or {"stage": "failed", "reason"}.
When its input ends, because the parent is gone, the worker ends its whole process group, whatever it is doing.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import os
import queue
import signal
import sys
import threading
import time
from typing import IO, Any

from numerics.errors import NumericsError
from numerics.trade.clock import Timing, median_time, own_seconds
from numerics.trade.comparisons.peer import PeerFailed, Unsupported
from numerics.trade.contender import Contender
from numerics.trade.scenes import scene_from_record

MEMORY_SHARE = 0.7
"""Of the machine's memory: more than this is answered by a MemoryError instead of by the whole machine."""


LONG = 20
"""A first run that takes so many budgets is not repeated: next to it, warming up is nothing."""


class Worker:
    """Answers requests on one channel."""

    def __init__(self, channel: IO[str]) -> None:
        """Take the channel; contenders are looked up when they are asked for."""
        self._channel = channel
        self._known: dict[str, dict[str, Contender]] = {}

    def answer(self, request: dict[str, Any]) -> None:
        """Run one request; whatever goes wrong is an answer, too."""
        try:
            self._run(request)
        except Unsupported as error:
            self._tell({"stage": "failed", "reason": f"not for this scene: {error}"})
        except MemoryError:
            self._tell({"stage": "failed", "reason": "out of memory"})
        except (NumericsError, PeerFailed) as error:
            self._tell({"stage": "failed", "reason": str(error)})
        except Exception as error:  # noqa: BLE001 - a peer may raise anything, and the table goes on
            self._tell({"stage": "failed", "reason": f"{type(error).__name__}: {error}"})

    def _run(self, request: dict[str, Any]) -> None:
        contender = self._contender(request["source"], request["contender"])
        scene, budget = scene_from_record(request["scene"]), float(request["budget"])
        start = time.perf_counter()
        call = contender.prepare(scene, request["setting"])
        self._tell({"stage": "prepared", "seconds": time.perf_counter() - start})
        start = time.perf_counter()
        run = call()
        waited = time.perf_counter() - start
        first = own_seconds(run, waited)
        self._tell({"stage": "ran", "seconds": first, "outcome": contender.outcome(run).as_record()})
        if budget > 0:
            del run
            timing = Timing(first, 0) if waited > LONG * budget else median_time(call, waited, budget)
            self._tell({"stage": "timed", "seconds": timing.seconds, "batches": timing.batches})

    def _contender(self, source: str, name: str) -> Contender:
        if source not in self._known:
            module, function = source.split(":")
            contenders = getattr(importlib.import_module(module), function)()
            self._known[source] = {one.label: one for one in contenders}
        return self._known[source][name]

    def _tell(self, answer: dict[str, Any]) -> None:
        print(json.dumps(answer), file=self._channel, flush=True)


def _requests() -> queue.Queue[dict[str, Any]]:
    """Read the input in a thread of its own, so that its end is seen while a run is busy."""
    waiting: queue.Queue[dict[str, Any]] = queue.Queue()

    def read() -> None:
        for line in sys.stdin:
            waiting.put(json.loads(line))
        if hasattr(os, "killpg"):
            os.killpg(os.getpgid(0), signal.SIGKILL)
        os._exit(1)  # Windows knows no groups

    threading.Thread(target=read, daemon=True).start()
    return waiting


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # Windows sets no such limits
        return
    whole = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(resource.RLIMIT_DATA, (int(MEMORY_SHARE * whole), resource.RLIM_INFINITY))


def main() -> None:
    """Answer requests until the parent is gone; whatever a contender prints goes to stderr."""
    channel = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    _limit_memory()
    worker, waiting = Worker(channel), _requests()
    while True:
        worker.answer(waiting.get())


if __name__ == "__main__":
    main()
