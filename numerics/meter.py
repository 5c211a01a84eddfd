"""Progress of what lasts, in the manner of tqdm: on a terminal one line on stderr after two seconds.

solving  42 %|########            | 3 s, 4 s left

Elsewhere a line after a minute, and one whenever the time has doubled.
"""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

_AFTER, _EVERY, _SILENT, _WIDTH = 2.0, 0.25, 60.0, 20
"""Seconds before the first line on a terminal, between two, and before the first one elsewhere; characters of the bar.
"""
_ACTIVE = threading.local()


class _Line:
    """What is shown: it is told how far the work is, and writes now and then."""

    def __init__(self, what: str) -> None:
        self.what, self.began, self.fraction = what, time.monotonic(), 0.0
        self.is_terminal, self.has_told = sys.stderr.isatty(), False
        self.due = self.began + (_AFTER if self.is_terminal else _SILENT)

    def __call__(self, done: int, whole: float) -> None:
        """Take a count and the fraction done (a float), or a count and how many there are (an int)."""
        self.fraction = whole if isinstance(whole, float) else done / max(whole, 1)
        if self.fraction < 1:
            self.tell()

    def tell(self) -> None:
        now = time.monotonic()
        if now < self.due:
            return
        spent, done, self.has_told = now - self.began, self.fraction, True
        self.due = now + (_EVERY if self.is_terminal else spent)
        bar, left = "", ""
        if done > 0:
            bar = f"{100 * done:3.0f} %|{'#' * int(_WIDTH * done):{_WIDTH}}| "
            left = f", {spent * (1 - done) / done:.0f} s left"
        line = f"{self.what} {bar}{spent:.0f} s{left}"
        sys.stderr.write(f"\r\033[K{line}" if self.is_terminal else f"{line}\n")
        sys.stderr.flush()

    def close(self) -> None:
        if self.has_told and self.is_terminal:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()


@contextmanager
def meter(
    what: str, given: Callable[..., None] | None = None, ticks: bool = True
) -> Iterator[Callable[..., None] | None]:
    """Yield what takes the progress of some work: what is `given`, or a line; None within other work that has one.

    With `ticks` it also counts the seconds of work that tells nothing. As a decorator it is the line of a function.
    """
    is_free = sys.stderr is not None and not getattr(_ACTIVE, "line", False)
    if given is not None or not is_free:
        yield given
        return
    line, ended = _Line(what), threading.Event()
    _ACTIVE.line = True

    def tick() -> None:
        while not ended.wait(max(line.due - time.monotonic(), _EVERY)):
            line.tell()

    ticker = threading.Thread(target=tick, daemon=True) if ticks else None
    if ticker is not None:
        ticker.start()
    try:
        yield line
    finally:
        ended.set()
        if ticker is not None:
            ticker.join()
        _ACTIVE.line = False
        line.close()
